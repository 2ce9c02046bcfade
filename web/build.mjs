// Makes web/dist/report.html, the page that the C++ build embeds: HTML, style, viewer and libraries
// in one file. `node build.mjs --check` writes nothing and fails if that file is not what the
// sources give.
import { build } from 'esbuild';
import { readFileSync, writeFileSync, mkdirSync } from 'node:fs';
import { dirname, join } from 'node:path';
import { fileURLToPath } from 'node:url';

const here = dirname(fileURLToPath(import.meta.url));
const target = join(here, 'dist', 'report.html');

const result = await build({
  entryPoints: [join(here, 'src', 'main.js')],
  bundle: true,
  minify: true,
  format: 'iife',
  target: ['chrome102', 'firefox113', 'safari16.4'],
  charset: 'utf8',
  legalComments: 'none',
  write: false,
  metafile: true,
  outdir: join(here, 'dist'),
});
const output = (ending) => result.outputFiles.find((f) => f.path.endsWith(ending)).text;
// Nothing in a script element may look like its end, nor start a comment of HTML.
const script = output('.js').replaceAll('</script', '<\\/script').replaceAll('<!--', '<\\!--');

// The licences of what is bundled, whole.
const licence = (name) =>
  `${name}\n\n${readFileSync(join(here, 'node_modules', name, 'LICENSE'), 'utf8').trim()}\n`;
const bundled = new Set();
for (const made of Object.values(result.metafile.outputs)) {
  for (const [input, { bytesInOutput }] of Object.entries(made.inputs)) {
    const match = input.match(/node_modules\/((?:@[^/]+\/)?[^/]+)\//);
    if (match && bytesInOutput > 0) bundled.add(match[1]);
  }
}
const notices = [...bundled].sort().map(licence).join('\n----\n\n').replaceAll('--', '- -');

const page = readFileSync(join(here, 'src', 'index.html'), 'utf8')
  .replace('<!--notices-->', () => `<!--\nThis page contains the following libraries.\n\n${notices}-->`)
  .replace('/*style*/', () => output('.css'))
  .replace('/*script*/', () => script);

if (process.argv.includes('--check')) {
  let committed = '';
  try {
    committed = readFileSync(target, 'utf8');
  } catch {}
  if (committed !== page) {
    console.error('web/dist/report.html is not what web/src gives: run `npm run build` in web/');
    process.exit(1);
  }
  console.log('web/dist/report.html is what web/src gives');
} else {
  mkdirSync(dirname(target), { recursive: true });
  writeFileSync(target, page);
  console.log(`web/dist/report.html: ${page.length} bytes, with ${[...bundled].sort().join(', ')}`);
}
