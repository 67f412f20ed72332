/**
 * `npm run fuzz`: opens 100,000 generated and damaged files, in as many processes as there are processors; see
 * packages/tools/fuzz. Failing ones are made small by fast-check and written to .cache/fuzz: mend the fault, and keep the file in
 * packages/tools/fuzz/found. `npm run fuzz -- --help` lists options.
 *
 * On another host, without npm: `npm run fuzz -- --pack fuzz.mjs` here, and `node fuzz.mjs` there.
 */
import { spawnSync } from 'node:child_process';
import { copyFileSync } from 'node:fs';
import { join, resolve } from 'node:path';
import { ensureInstalled } from './ensureInstalled.mjs';
import { root } from './root.mjs';

ensureInstalled();
const { build } = await import('vite');
const { serverSourceConditions } = await import('./sourceConditions.mjs');
const outDir = join(root, '.cache/fuzz-bundle');
await build({
  configFile: false,
  root: join(root, 'packages/tools'),
  publicDir: false,
  logLevel: 'warn',
  ssr: { noExternal: true, resolve: { conditions: serverSourceConditions } },
  build: {
    ssr: 'fuzz/atLength.ts',
    outDir,
    emptyOutDir: true,
    target: 'node20',
    rolldownOptions: { output: { entryFileNames: 'fuzz.mjs', codeSplitting: false } },
  },
});
const bundle = join(outDir, 'fuzz.mjs');
const args = process.argv.slice(2);
const pack = args.indexOf('--pack');
if (pack < 0)
  process.exitCode = spawnSync(process.execPath, [bundle, ...args], { stdio: 'inherit', cwd: root }).status ?? 1;
else if (args[pack + 1]) copyFileSync(bundle, resolve(args[pack + 1]));
else {
  console.error('--pack: name the file that is to be made.');
  process.exitCode = 1;
}
