import { existsSync, readdirSync, readFileSync } from 'node:fs';
import { join } from 'node:path';
import { gzipSync } from 'node:zlib';
import { liveFolder } from './liveServer.mjs';

/** Folder of the gallery's examples. */
export const galleryFolder = join(liveFolder, 'gallery');

/** File of the examples' figures, written by `npm run gallery`. */
export const figuresFile = join(galleryFolder, 'figures.json');

/**
 * An example of the gallery, as its docblock tells it.
 *
 * @typedef {object} GalleryExample
 * @property {string} name - name of its file without ending
 * @property {string} file - name of its file
 * @property {string[]} others - files of the folder of its name: what its worker runs
 * @property {string} title - first line of the docblock
 * @property {string} sentence - second paragraph
 * @property {string[]} tags
 * @property {number} seconds - time on the page's clock of its picture (s)
 * @property {number} frames - frames until then
 * @property {string | null} editor - query by which the editor opens it; null where it cannot
 */

/**
 * How far the picture of an example is from stock three's.
 *
 * @typedef {object} GalleryFigures
 * @property {string} technique - technique that drew
 * @property {number | null} psnr - dB after sRGB encoding; null where both are equal
 * @property {number} largest - largest linear difference of a channel
 * @property {string[]} leftOut - parts that stock three cannot draw, compared without
 */

/** @returns {GalleryExample[]} by name */
export function readExamples() {
  return readdirSync(galleryFolder)
    .filter((file) => /\.tsx?$/.test(file))
    .toSorted()
    .map((file) => {
      const example = parseExample(file, readFileSync(join(galleryFolder, file), 'utf8'));
      const folder = join(galleryFolder, example.name);
      const others = existsSync(folder) ? readdirSync(folder).toSorted() : [];
      return { ...example, others: others.map((other) => `${example.name}/${other}`) };
    });
}

/**
 * @param {string} file - name of the file
 * @param {string} source
 * @returns {Omit<GalleryExample, 'others'>}
 * @throws {Error} when the docblock lacks a title, a sentence or tags
 */
export function parseExample(file, source) {
  const block = /^\/\*\*\n([\s\S]*?)\n \*\//.exec(source)?.[1].replace(/^ \* ?/gm, '') ?? '';
  const [title, sentence] = block.split('\n\n').map((part) => part.trim().replace(/\n/g, ' '));
  const tag = (/** @type {string} */ key) => new RegExp(`^@${key} (.+)$`, 'm').exec(block)?.[1];
  const tags = tag('tags')?.split(', ') ?? [];
  if (!title || !sentence || sentence.startsWith('@') || tags.length === 0)
    throw new Error(`${file}: begin the file with a docblock of a title, a sentence and @tags.`);
  const [seconds = 2, frames = 6] = tag('still')?.split(' ').map(Number) ?? [];
  return {
    name: file.replace(/\.tsx?$/, ''),
    file,
    title,
    sentence,
    tags,
    seconds,
    frames,
    editor: tag('editor') ?? null,
  };
}

/**
 * Spanish texts of the gallery: tags by their English ones, and title and sentence of each example by its name.
 *
 * @returns {{ tags: Record<string, string>, examples: Record<string, [title: string, sentence: string]> }}
 */
export const readSpanish = () => JSON.parse(readFileSync(join(galleryFolder, 'es.json'), 'utf8'));

/** @returns {Record<string, GalleryFigures>} by name */
export function readFigures() {
  return existsSync(figuresFile) ? JSON.parse(readFileSync(figuresFile, 'utf8')) : {};
}

/**
 * Gzipped sizes of the built scripts that an example loads before its first frame, without code that Farol fetches once
 * a scene needs it; empty before the first build. In a worker's bundle, three's code counts among `others`.
 *
 * @returns {Record<string, { three: number, others: number }>} bytes by name: three's, all others
 */
export function readSizes() {
  const dist = join(liveFolder, 'dist');
  const file = join(dist, '.vite/manifest.json');
  if (!existsSync(file)) return {};
  /** @type {Record<string, { file: string, name?: string, imports?: string[], assets?: string[], isEntry?: boolean }>} */
  const manifest = JSON.parse(readFileSync(file, 'utf8'));
  /** @type {Map<string, number>} */
  const sizes = new Map();
  const sizeOf = (/** @type {string} */ path) => {
    if (!sizes.has(path)) sizes.set(path, gzipSync(readFileSync(join(dist, path))).length);
    return sizes.get(path) ?? 0;
  };
  const entries = Object.keys(manifest).filter((key) => manifest[key].isEntry);
  const examples = Object.keys(manifest).filter((key) => key.startsWith('gallery/'));
  return Object.fromEntries(
    examples.map((key) => {
      const all = new Set([...entries, key]);
      for (const each of all) for (const found of manifest[each].imports ?? []) all.add(found);
      let three = 0;
      let others = 0;
      // a worker's script is a bundle of its own, which has three in it
      for (const worker of manifest[key].assets ?? []) if (worker.endsWith('.js')) others += sizeOf(worker);
      for (const each of all) {
        const size = sizeOf(manifest[each].file);
        if (manifest[each].name === 'three') three += size;
        else others += size;
      }
      return [key.replace(/^gallery\/|\.tsx?$/g, ''), { three, others }];
    }),
  );
}
