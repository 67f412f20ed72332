import { mkdirSync, mkdtempSync, rmSync, writeFileSync } from 'node:fs';
import { tmpdir } from 'node:os';
import { join } from 'node:path';
import { gzipSync } from 'node:zlib';
import { afterEach, beforeEach, expect, it } from 'vitest';
import { bundleSize, scriptSize } from './bundleSize.mjs';

let folder = '';
beforeEach(() => {
  folder = mkdtempSync(join(tmpdir(), 'farol-size-'));
  mkdirSync(join(folder, 'chunks'));
});
afterEach(() => rmSync(folder, { recursive: true }));

const write = (name: string, source: string) => {
  writeFileSync(join(folder, name), source);
  return gzipSync(source, { level: 9 }).length;
};

it('counts an entry with what it imports of its package, each file once', () => {
  const parts = [
    write('index.js', "import{a}from'./chunks/a.js';import{b}from'./chunks/b.js';import 'three';export{a,b};"),
    write('chunks/a.js', "export*from'./b.js';export const a=1;"),
    write('chunks/b.js', 'export const b=2;'),
  ];
  write('chunks/old.js', 'export const left = "from an earlier build";');
  write('extra.js', "import{a}from'./chunks/a.js';export const extra=a;");
  expect(bundleSize(folder)).toBe(parts.reduce((sum, size) => sum + size, 0));
});

it('leaves out what is imported late', () => {
  write('chunks/late.js', 'export const late = 1;');
  const size = write('index.js', "export const late=()=>import('./chunks/late.js');");
  expect(bundleSize(folder)).toBe(size);
});

it('does not take a package that was not built for a small one', () => {
  expect(() => bundleSize(folder)).toThrow(/index\.js is not there: build/);
});

it('counts the script that a page names', () => {
  const size = write('chunks/start.js', 'export const start = 1;');
  write('index.html', '<script type="module" crossorigin src="./chunks/start.js"></script>');
  expect(scriptSize(folder)).toBe(size);
});

it('does not take a page without a script for a small one', () => {
  write('index.html', '<p>Nothing.</p>');
  expect(() => scriptSize(folder)).toThrow(/index\.html names no script/);
  expect(() => scriptSize(folder, 'stage.html')).toThrow(/stage\.html is not there: build/);
});
