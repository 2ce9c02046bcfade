// One colour a method, the same in every figure; after Okabe and Ito, readable without colour vision.
const kFixed = {
  trad: '#8a8f98', tdibm: '#0072b2', 'tdibm-h:1e-16': '#56b4e9', 'tdibm-h:1e-12': '#009e73',
  'tdibm-h:1e-8': '#b3a51a', 'tdibm-h:1e-12@absolute': '#7fbf7b', 'tdibm-e': '#d55e00', 'tdibm-e-literal': '#e69f00',
  'tdibm-rational': '#9467bd', 'tdibm-c': '#cc2f7f',
};
const kMore = ['#17becf', '#bcbd22', '#8c564b', '#e377c2', '#7f7f7f', '#1f77b4'];
const given = new Map();

export function colourOf(method) {
  if (kFixed[method]) return kFixed[method];
  if (!given.has(method)) given.set(method, kMore[given.size % kMore.length]);
  return given.get(method);
}
