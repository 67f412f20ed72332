import { existsSync, readdirSync, readFileSync } from 'node:fs';
import { basename, join } from 'node:path';
import { publishedPackages } from '@farol/tools/publishedPackages';
import { root } from '@farol/tools/root';

/** A block of code of a README or a page of docs, or an example of the API's pages that needs a browser. */
export interface Sample {
  /** Page, from the repository's root, and the number of the block, from 1: `packages/bake/README.md 1`. */
  readonly name: string;
  readonly language: 'ts' | 'tsx';
  readonly code: string;
}

/**
 * Samples of the README at the root, of the packages' READMEs and docs, and of `e2e/samples/browser`; authoring.md's have a
 * test of their own.
 */
export function readSamples(): Sample[] {
  const pages = publishedPackages().flatMap(({ folder }) => {
    const docs = join(root, folder, 'docs');
    const names = existsSync(docs) ? readdirSync(docs).filter((name) => name.endsWith('.md')) : [];
    return [`${folder}/README.md`, ...names.map((name) => `${folder}/docs/${name}`)];
  });
  const browser = 'e2e/samples/browser';
  const files = readdirSync(join(root, browser)).map((name): Sample => {
    const path = `${browser}/${name}`;
    return { name: path, language: 'ts', code: readFileSync(join(root, path), 'utf8') };
  });
  const blocks = ['README.md', ...pages]
    .filter((page) => basename(page) !== 'authoring.md')
    .flatMap((page) =>
      [...readFileSync(join(root, page), 'utf8').matchAll(/```(tsx?)\n(.*?)```/gs)].map(
        ([, language, code], i): Sample => ({ name: `${page} ${i + 1}`, language: language as 'ts' | 'tsx', code }),
      ),
    );
  return [...blocks, ...files];
}
