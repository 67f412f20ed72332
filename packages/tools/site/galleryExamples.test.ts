import { existsSync, readFileSync, statSync } from 'node:fs';
import { join } from 'node:path';
import { describe, expect, it } from 'vitest';
import { importsOf } from '../importsOf.mjs';
import { galleryFolder, parseExample, readExamples, readFigures, readSpanish } from './galleryExamples.mjs';
import { liveFolder } from './liveServer.mjs';

const examples = readExamples();

describe('the gallery', () => {
  it('has at least 40 examples, each with a title of its own', () => {
    expect(examples.length).toBeGreaterThanOrEqual(40);
    expect(new Set(examples.map(({ title }) => title)).size).toBe(examples.length);
  });

  it('has examples that are whole: they import packages alone', () => {
    const files = examples.flatMap(({ file, others }) => [file, ...others]);
    const relative = files.flatMap((file) =>
      importsOf(file, readFileSync(join(galleryFolder, file), 'utf8'))
        .map(({ specifier }) => specifier)
        .filter((specifier) => specifier.startsWith('.')),
    );
    expect(relative).toEqual([]);
  });

  it('has a picture of each, of at most 25 kB, and of less than 1 MB together', () => {
    const picture = (name: string) => join(liveFolder, 'assets/stills/gallery', `${name}.webp`);
    expect(examples.filter(({ name }) => !existsSync(picture(name))).map(({ name }) => name)).toEqual([]);
    const sizes = examples.map(({ name }) => statSync(picture(name)).size);
    expect(Math.max(...sizes)).toBeLessThanOrEqual(25_000);
    expect(sizes.reduce((sum, size) => sum + size, 0)).toBeLessThan(1_000_000);
  });

  it('has a Spanish title and sentence of each, and a word for each tag, and of no other', () => {
    const spanish = readSpanish();
    expect(Object.keys(spanish.examples).toSorted()).toEqual(examples.map(({ name }) => name).toSorted());
    expect(
      Object.values(spanish.examples).filter((texts) => texts.length !== 2 || texts.some((text) => !text)),
    ).toEqual([]);
    const tags = new Set(examples.flatMap((example) => example.tags));
    expect(Object.keys(spanish.tags).toSorted()).toEqual([...tags].toSorted());
    const codeOf = (text: string): string[] => (text.match(/`[^`]+`/g) ?? []).toSorted();
    for (const { name, sentence } of examples) expect.soft(codeOf(spanish.examples[name][1])).toEqual(codeOf(sentence));
  });

  it('has figures of each, and of no other', () => {
    expect(Object.keys(readFigures()).toSorted()).toEqual(examples.map(({ name }) => name).toSorted());
  });
});

describe('the docblock of an example', () => {
  const source = (block: string) => `/**\n${block}\n */\nimport 'three';\n`;

  it('gives title, sentence, tags, and the moment of its picture', () => {
    const block = ' * A lamp\n *\n * One lamp,\n * and a floor.\n *\n * @tags start, cost\n * @still 4 20';
    expect(parseExample('a-lamp.tsx', source(block))).toEqual({
      ...{ name: 'a-lamp', file: 'a-lamp.tsx', title: 'A lamp', sentence: 'One lamp, and a floor.' },
      ...{ tags: ['start', 'cost'], seconds: 4, frames: 20, editor: null },
    });
  });

  it('may not lack them', () => {
    expect(() => parseExample('x.ts', source(' * A lamp\n *\n * @tags start'))).toThrow('x.ts: begin the file');
    expect(() => parseExample('x.ts', source(' * A lamp\n *\n * One lamp.'))).toThrow('@tags');
  });
});
