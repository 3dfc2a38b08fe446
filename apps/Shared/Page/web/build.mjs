// Makes ../page.bundle.html, the page without data, of the sources here. `--check` only says whether it is that already.
import { readdirSync, readFileSync, writeFileSync } from 'node:fs';
import { dirname, join } from 'node:path';
import { fileURLToPath } from 'node:url';
import { build } from 'esbuild';

const here = dirname(fileURLToPath(import.meta.url));
const target = join(here, '..', 'page.bundle.html');
const read = (name) => readFileSync(join(here, name), 'utf8');
const escape = (text) => text.replace(/&/g, '&amp;').replace(/</g, '&lt;');

/** The packages that are in the bundle, by the paths of its inputs. */
function findPackages(inputs) {
  const names = Object.keys(inputs).map((path) => /node_modules\/((?:@[^/]+\/)?[^/]+)\//.exec(path)?.[1]);
  return [...new Set(names.filter(Boolean))].sort();
}

/** All files of licences that a package has, or else the first comment of its source. */
function readNotice(name) {
  const folder = join(here, 'node_modules', name);
  const { version, license } = JSON.parse(readFileSync(join(folder, 'package.json'), 'utf8'));
  const readIn = (file) => readFileSync(join(folder, file), 'utf8');
  const texts = readdirSync(folder).filter((file) => /^(licen[cs]e|copyright|notice)/i.test(file)).sort().map(readIn);
  if (texts.length === 0) {
    texts.push(/^\s*\/\*([^]*?)\*\//.exec(readIn(`${name}.js`))?.[1] ?? '');
  }
  if (!texts.every((text) => /copyright/i.test(text))) {
    throw new Error(`${name} has no notice of its licence, which the bundle must have`);
  }
  return [`${name} ${version} (${license})`, ...texts.map((text) => text.trim())].join('\n\n');
}

const result = await build({
  entryPoints: [join(here, 'main.js')],
  absWorkingDir: here,
  bundle: true,
  charset: 'ascii',
  format: 'iife',
  legalComments: 'none', // All notices are in the page.
  metafile: true,
  minify: true,
  target: 'es2019', // Older than ??, which C++ takes for the begin of a trigraph.
  write: false,
});
const style = await build({ entryPoints: [join(here, 'page.css')], absWorkingDir: here, charset: 'ascii', minify: true, write: false });
const packages = findPackages(result.metafile.inputs);
const own = 'TissueTessellation (Apache-2.0)\n\nCopyright The TissueTessellation contributors. The page and its data are made by it.';
const notices = [own, ...packages.map(readNotice)].join('\n\n----\n\n');
const script = result.outputFiles[0].text.trim().replace(/<\/(script)/gi, '<\\/$1').replace(/<!--/g, '<\\!--');
const parts = { '/*STYLE*/': style.outputFiles[0].text.trim(), '<!--NOTICES-->': escape(notices), '/*SCRIPT*/': script };
let page = read('page.html');
for (const [place, text] of Object.entries(parts)) {
  page = page.replace(place, () => text);
}
page = page.replace(/[^\x00-\x7f]/g, (character) => `&#${character.codePointAt(0)};`);
if (/\?\?[=/'()!<>-]/.test(page)) {
  throw new Error('the page has a trigraph of C++, which it is built in by');
}
if (process.argv.includes('--check')) {
  if (page !== readFileSync(target, 'utf8')) {
    console.error('page.bundle.html is not what its sources make: npm run build');
    process.exit(1);
  }
} else {
  writeFileSync(target, page);
  console.log(`page.bundle.html: ${page.length} bytes, with ${packages.join(', ')}`);
}
