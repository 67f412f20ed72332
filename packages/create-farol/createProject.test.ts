import { spawnSync } from 'node:child_process';
import { existsSync, mkdirSync, mkdtempSync, readdirSync, readFileSync, rmSync, writeFileSync } from 'node:fs';
import { tmpdir } from 'node:os';
import { join, win32 } from 'node:path';
import { fileURLToPath } from 'node:url';
import { parseFile, readSceneFile } from '@farol/engine/files';
import { publishedPackages } from '@farol/tools/publishedPackages';
import { root } from '@farol/tools/root';
import { parseSync } from 'vite';
import { afterAll, expect, it, test } from 'vitest';
import { behind, createProject, CreateError, fileSpecifier, kinds, packageName } from './createProject.mjs';

const temporary = mkdtempSync(join(tmpdir(), 'farol-create-'));
afterAll(() => rmSync(temporary, { recursive: true, force: true }));
const read = (...path: string[]): string => readFileSync(join(...path), 'utf8');
const index = fileURLToPath(new URL('index.mjs', import.meta.url));
const names = Object.keys(kinds) as (keyof typeof kinds)[];

test.each(names)('%s: a project in TypeScript, and in what is JavaScript without its endings', (kind) => {
  const [typed, plain] = ['My Page', 'script'].map((name) => join(temporary, kind, name));
  createProject({ folder: typed, kind, typescript: true });
  createProject({ folder: plain, kind, typescript: false });

  const manifest = JSON.parse(read(typed, 'package.json'));
  expect(manifest).toMatchObject({ name: 'my-page', scripts: { build: 'tsc && vite build' } });
  expect(read(typed, 'index.html')).toContain('<title>my-page</title>');
  expect(read(typed, 'README.md')).toMatch(/^# my-page\n/);
  expect(read(typed, 'README.md').trimEnd().split('\n').length).toBeLessThanOrEqual(10);
  expect(read(typed, '.gitignore')).toContain('node_modules/');
  expect(readdirSync(typed)).not.toContain('_gitignore');

  const files = readdirSync(plain, { recursive: true, encoding: 'utf8' });
  expect(files.filter((name) => /\.tsx?$|tsconfig/.test(name))).toEqual([]);
  const scripts = files.filter((name) => /\.jsx?$/.test(name));
  expect(scripts.length).toBe(readdirSync(join(typed, 'src')).length + 1);
  for (const name of scripts) expect(parseSync(name, read(plain, name)).errors, name).toEqual([]);
  const [, main] = /src="\/(.+?)"/.exec(read(plain, 'index.html'))!;
  expect(existsSync(join(plain, main)), main).toBe(true);
  expect(read(plain, 'package.json')).not.toMatch(/typescript|@types|tsc/);
});

it('refuses a folder that is not empty, but for the folder of Git, and leaves it as it was', () => {
  const folder = join(temporary, 'taken');
  mkdirSync(join(folder, '.git'), { recursive: true });
  createProject({ folder, kind: 'plain', typescript: true });
  const before = readdirSync(folder);
  const again = () => createProject({ folder, kind: 'scene', typescript: true });
  expect(again).toThrow(new CreateError(`The folder ${folder} is not empty: choose another name, or empty it first.`));
  expect(readdirSync(folder)).toEqual(before);
});

it('plays a file of the editor, and says what it misses before it writes anything', async () => {
  const folder = join(temporary, 'night');
  const scene = join(root, 'public/scenes/night-in-the-temple.farol');
  const missing = { folder, kind: 'scene', typescript: true } as const;
  expect(() => createProject({ ...missing, scene: `${scene}x` })).toThrow(/There is no file .*farolx: name a saved/);
  expect(() => createProject({ ...missing, tarballs: folder })).toThrow(/run "npm run pack" in a clone/);
  expect(existsSync(folder)).toBe(false);
  createProject({ ...missing, scene });
  expect(readFileSync(join(folder, 'public/scene.farol'))).toEqual(readFileSync(scene));
  expect(readdirSync(join(folder, 'public'))).toEqual(['scene.farol']);
  expect(read(folder, 'src/main.ts')).toContain("'./scene.farol'");
  const sample = await readSceneFile(readFileSync(new URL('templates/scene/public/scene.json', import.meta.url)));
  expect(parseFile(sample.text).objects.length).toBeGreaterThan(60);
});

test.each([
  ['/home/ana/Street of Lamps', 'street-of-lamps'],
  ['C:\\Users\\Ana\\Farol 2', 'farol-2'],
  ['/home/ana/..scene', 'scene'],
  ['/home/ana/灯', 'farol-app'],
])('%s is the package %s', (folder, name) => expect(packageName(folder)).toBe(name));

it('names tarballs by the way to them, with the slashes of every system', () => {
  const [folder, near, far] = ['C:\\work\\page', 'C:\\work\\farol\\dist\\x.tgz', 'D:\\farol\\x.tgz'];
  expect(fileSpecifier(folder, near, win32)).toBe('file:../farol/dist/x.tgz');
  expect(fileSpecifier(folder, far, win32)).toBe('file:D:/farol/x.tgz');
});

it('has npm take from tarballs all that a project needs of Farol', () => {
  const manifests = publishedPackages().map(({ manifest }) => manifest);
  for (const kind of names) {
    const wanted = Object.keys(
      JSON.parse(read(root, `packages/create-farol/templates/${kind}/package.json`)).dependencies,
    );
    const ours = wanted.filter((name) => name.startsWith('@farol/'));
    const given = new Set(ours.flatMap((name) => [name, ...((behind as Record<string, string[]>)[name] ?? [])]));
    for (const name of given)
      for (const needed of Object.keys(manifests.find((each) => each.name === name)!.dependencies ?? {}))
        expect(needed.startsWith('@farol/') && !given.has(needed), `${kind}: ${name} needs ${needed}`).toBe(false);
  }
});

it('asks for the versions that the repository is tested with, and later ones that keep their promises', () => {
  const locked = JSON.parse(read(root, 'package-lock.json')).packages;
  for (const kind of names) {
    const { dependencies, devDependencies } = JSON.parse(
      read(root, `packages/create-farol/templates/${kind}/package.json`),
    ) as Record<string, Record<string, string>>;
    for (const [name, range] of Object.entries({ ...dependencies, ...devDependencies })) {
      const places = [
        name.replace('@farol', 'packages'),
        `packages/engine/node_modules/${name}`,
        `node_modules/${name}`,
      ];
      const { version } = locked[places.find((place) => place in locked)!];
      // three and packages below 1.0 may break compatibility between minor versions
      expect(range, name).toBe(`${/three$|rapier/.test(name) ? '~' : '^'}${version}`);
    }
  }
});

test.each([
  ['answers of three questions', [], 'street\n3\nno\n', ['street', 'scene.json', 'main.js'], 3],
  ['a kind by its name, asked again after one that is none', ['lamps'], '4\nreact\n\n', ['lamps', 'App.tsx'], 3],
  ['options in place of all answers', ['page', '--kind', 'react', '--js'], '', ['page', 'App.jsx'], 0],
  ['defaults where nothing is to be asked', ['--yes'], '', ['farol-app', 'main.ts'], 0],
  ['defaults where nobody answers', [], '', ['farol-app', 'main.ts'], 3],
])('%s', (_name, args, input, made, asked) => {
  const cwd = mkdtempSync(join(temporary, 'cli-'));
  const { stdout, stderr, status } = spawnSync(process.execPath, [index, ...args, '--no-install'], {
    ...{ cwd, input, encoding: 'utf8' },
    env: { ...process.env, npm_config_user_agent: 'pnpm/10.0.0' },
  });
  expect([stderr, status]).toEqual(['', 0]);
  expect(stdout.match(/farol-app\): |Number \(1\): |Y\/n\): /g) ?? []).toHaveLength(asked);
  const [folder, ...files] = made;
  const found = readdirSync(join(cwd, folder), { recursive: true, encoding: 'utf8' }).join('\n');
  for (const file of files) expect(found).toContain(file);
  expect(stdout).toMatch(new RegExp(`Next:\n  cd ${folder}\n  pnpm install\n  pnpm run dev\n$`));
});

test.each([
  [['x', '--kind', 'vue'], 'There is no kind "vue": the kinds are plain, react, scene.'],
  [['x', '--kind', 'react', '--scene', 'a.farol'], '--scene is for the kind scene: leave --kind out.'],
  [['x', '--scene', 'a.farol', '--yes'], /^There is no file .*a\.farol: name a saved one\.$/],
  [['.', '--yes'], /^The folder .* is not empty: choose another name, or empty it first\.$/],
  [['x', '--tar', 'a'], /^Unknown option '--tar'/],
])('%s ends in one sentence', (args, sentence) => {
  const cwd = mkdtempSync(join(temporary, 'bad-'));
  writeFileSync(join(cwd, 'own.txt'), '');
  const { stderr, status } = spawnSync(process.execPath, [index, ...args], { cwd, encoding: 'utf8' });
  expect(stderr.trim()).toMatch(sentence);
  expect(status).toBe(1);
  expect(readdirSync(cwd)).toEqual(['own.txt']);
});
