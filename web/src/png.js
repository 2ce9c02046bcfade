// A figure as a picture.
const kDensity = 2;  // pixels of the picture for one of the page

/** An SVG of the page as an image; what the page's style gives it is written into it. */
async function imageOf(svg) {
  const style = getComputedStyle(svg);
  const copy = svg.cloneNode(true);
  const { width, height } = svg.getBoundingClientRect();
  copy.setAttribute('xmlns', 'http://www.w3.org/2000/svg');
  copy.setAttribute('width', width);
  copy.setAttribute('height', height);
  Object.assign(copy.style, { color: style.color, fontFamily: style.fontFamily, fontSize: style.fontSize });
  const text = new XMLSerializer().serializeToString(copy)
    .replace(/var\((--[\w-]+)\)/g, (_, name) => style.getPropertyValue(name).trim());
  const image = new Image();
  image.src = `data:image/svg+xml,${encodeURIComponent(text)}`;
  await image.decode();
  return image;
}

/** The plots, headings and legends of an element as PNG, where they stand in the page. */
export async function pngOf(element) {
  const origin = element.getBoundingClientRect();
  const plots = [...element.querySelectorAll('svg')];
  // Plots that the page lets scroll reach out of the element.
  const right = Math.max(origin.right, ...plots.map((svg) => svg.getBoundingClientRect().right + 8));
  const canvas = Object.assign(document.createElement('canvas'),
    { width: Math.ceil(kDensity * (right - origin.left)), height: Math.ceil(kDensity * origin.height) });
  const pen = canvas.getContext('2d');
  pen.scale(kDensity, kDensity);
  pen.translate(-origin.left, -origin.top);
  const fill = (one) => {
    const { left, top, width, height } = one.getBoundingClientRect();
    pen.fillStyle = getComputedStyle(one).backgroundColor;
    pen.fillRect(left, top, one === element ? right - left : width, height);
  };
  [element, ...element.querySelectorAll('.legend i')].forEach(fill);
  for (const text of element.querySelectorAll('h3, h4, .legend span')) {
    const range = document.createRange();
    range.selectNodeContents(text.lastChild);
    const { left, top, height } = range.getBoundingClientRect();
    const style = getComputedStyle(text);
    Object.assign(pen, { font: style.font, fillStyle: style.color, textBaseline: 'middle' });
    pen.fillText(text.textContent, left, top + height / 2);
  }
  for (const svg of plots) {
    const { left, top, width, height } = svg.getBoundingClientRect();
    if (svg.closest('.inset')) fill(svg.closest('.inset'));
    pen.drawImage(await imageOf(svg), left, top, width, height);
  }
  return new Promise((resolve) => canvas.toBlob(resolve, 'image/png'));
}
