#!/usr/bin/env node
/** `npm create farol`: asks for everything that its options leave open, writes a project, and installs its packages. */
import { spawnSync } from 'node:child_process';
import { basename, isAbsolute, relative, resolve } from 'node:path';
import { createInterface } from 'node:readline';
import { parseArgs } from 'node:util';
import { CreateError, createProject, folderProblem, kinds } from './createProject.mjs';

const help = `npm create farol [folder] [-- options]: a page that Farol lights

  --kind plain|react|scene  ${Object.entries(kinds)
    .map(([kind, { label }]) => `${kind}: ${label}`)
    .join('; ')}
  --scene FILE              plays that file (.farol or .json); the kind is scene then
  --ts, --js                TypeScript (the default) or JavaScript
  --yes                     asks nothing: farol-app, plain, TypeScript where no option says otherwise
  --no-install              writes the files alone
  --tarballs FOLDER         takes Farol's packages from there ("npm run pack" in a clone), not from npm's registry
  --help                    this`;

try {
  await main();
} catch (error) {
  const isOurs = error instanceof CreateError || /** @type {{ code?: string }} */ (error).code?.startsWith('ERR_PARSE');
  if (!isOurs) throw error;
  console.error(/** @type {Error} */ (error).message);
  process.exitCode = 1;
}

async function main() {
  const { values, positionals } = parseArgs({
    options: {
      kind: { type: 'string' },
      scene: { type: 'string' },
      ts: { type: 'boolean' },
      js: { type: 'boolean' },
      yes: { type: 'boolean', short: 'y', default: false },
      'no-install': { type: 'boolean', default: false },
      tarballs: { type: 'string' },
      help: { type: 'boolean', short: 'h', default: false },
    },
    allowPositionals: true,
  });
  if (values.help) return console.log(help);
  const given = values.kind ?? (values.scene === undefined ? undefined : 'scene');
  if (given !== undefined && kindOf(given) === null)
    throw new CreateError(`There is no kind "${given}": the kinds are ${Object.keys(kinds).join(', ')}.`);
  if (values.scene !== undefined && given !== 'scene')
    throw new CreateError('--scene is for the kind scene: leave --kind out.');

  const ask = questions(values.yes);
  const folder = resolve(positionals[0] ?? (await ask('Folder (farol-app): ', (answer) => answer || 'farol-app')));
  const problem = folderProblem(folder);
  if (problem !== null) throw new CreateError(problem);
  const menu = Object.values(kinds).map(({ label }, i) => `  ${i + 1}  ${label}\n`);
  const kind =
    kindOf(given ?? '') ?? (await ask(`Kind\n${menu.join('')}Number (1): `, (answer) => kindOf(answer || '1')));
  const typescript = values.js ? false : values.ts || (await ask('TypeScript? (Y/n): ', yesOrNo));
  ask.end();

  const [scene, tarballs] = [values.scene, values.tarballs].map((path) => (path === undefined ? null : resolve(path)));
  createProject({ folder, kind, typescript, scene, tarballs });
  console.log(`\nMade ${folder}.`);

  const manager = /^(npm|pnpm|yarn|bun)\//.exec(process.env.npm_config_user_agent ?? '')?.[1] ?? 'npm';
  const isInstalled = !values['no-install'] && install(manager, folder);
  const way = relative(process.cwd(), folder);
  const steps = [
    ...(way === '' ? [] : [`cd ${quoted(way.startsWith('..') || isAbsolute(way) ? folder : way)}`]),
    ...(isInstalled ? [] : [`${manager} install`]),
    `${manager} run dev`,
  ];
  console.log(`\nNext:\n  ${steps.join('\n  ')}`);
  if (!isInstalled && !values['no-install']) {
    console.error(`\n${manager} install failed in ${basename(folder)}: its message is above.`);
    process.exitCode = 1;
  }
}

/** @param {string} answer - name or number @returns {import('./createProject.mjs').Kind | null} */
function kindOf(answer) {
  const names = /** @type {import('./createProject.mjs').Kind[]} */ (Object.keys(kinds));
  return names.find((name, i) => answer === name || answer === String(i + 1)) ?? null;
}

/** @param {string} answer - empty means yes */
function yesOrNo(answer) {
  return /^(y(es)?)?$/i.test(answer) ? true : /^no?$/i.test(answer) ? false : null;
}

/** Quotes a path for a shell if it contains spaces. @param {string} path */
function quoted(path) {
  return /\s/.test(path) ? `"${path}"` : path;
}

/**
 * Makes a function that asks until an answer is valid. It uses the default, as for an empty answer, without asking or
 * at the end of the input.
 *
 * @param {boolean} areDefaults - whether defaults are used without asking
 */
function questions(areDefaults) {
  /** @type {import('node:readline').Interface | null} */
  let reader = null;
  /** @type {AsyncIterator<string> | null} */
  let lines = null;
  /** @template T @param {string} question @param {(answer: string) => T | null} read @returns {Promise<T>} */
  const ask = async (question, read) => {
    for (;;) {
      if (areDefaults) return /** @type {T} */ (read(''));
      reader ??= createInterface({ input: process.stdin });
      lines ??= reader[Symbol.asyncIterator]();
      process.stdout.write(question);
      const { value, done } = await lines.next();
      const answer = read(done ? '' : value.trim());
      if (answer !== null) return answer;
    }
  };
  return Object.assign(ask, { end: () => reader?.close() });
}

/** @param {string} manager @param {string} folder @returns {boolean} whether all packages are installed */
function install(manager, folder) {
  const script = manager === 'npm' ? process.env.npm_execpath : undefined; // npm's own script runs without a shell
  const [command, ...args] = script?.endsWith('.js') ? [process.execPath, script, 'install'] : [manager, 'install'];
  const shell = command === manager && process.platform === 'win32';
  return spawnSync(command, args, { cwd: folder, stdio: 'inherit', shell }).status === 0;
}
