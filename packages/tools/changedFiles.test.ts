import { spawnSync } from 'node:child_process';
import { mkdtempSync, rmSync, writeFileSync } from 'node:fs';
import { tmpdir } from 'node:os';
import { join } from 'node:path';
import { afterAll, beforeAll, expect, it } from 'vitest';
import { changedFiles } from './changedFiles.mjs';

let folder: string;

function git(...args: string[]): void {
  const person = ['-c', 'user.name=a', '-c', 'user.email=a@example.org', '-c', 'commit.gpgsign=false'];
  const { status, stderr } = spawnSync('git', [...person, ...args], { cwd: folder, encoding: 'utf8' });
  if (status !== 0) throw new Error(stderr);
}

const write = (name: string, text: string): void => writeFileSync(join(folder, name), text);

beforeAll(() => {
  folder = mkdtempSync(join(tmpdir(), 'farol-changed-'));
  git('init', '-q');
  write('.gitignore', 'built.js\n');
  for (const name of ['first.ts', 'gone.ts', 'same.ts']) write(name, '1');
  git('add', '.');
  git('commit', '-q', '-m', 'first');
  write('first.ts', '2');
  git('commit', '-q', '-a', '-m', 'second');
});

afterAll(() => rmSync(folder, { recursive: true }));

it('are those of the last commit where nothing has changed since', () => {
  expect(changedFiles(folder)).toEqual(['first.ts']);
});

it('are those that are edited, staged or new, without what is ignored or gone', () => {
  write('same.ts', '2');
  write('staged.ts', '1');
  git('add', 'staged.ts');
  write('new.ts', '1');
  write('built.js', '1');
  rmSync(join(folder, 'gone.ts'));
  expect(changedFiles(folder).toSorted()).toEqual(['new.ts', 'same.ts', 'staged.ts']);
});
