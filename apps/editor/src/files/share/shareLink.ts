import { formatCount, shortText, t } from '@farol/editing';
import type { Scene } from '@farol/engine';
import { inlineAssets } from '@farol/engine/files';
import { encodeLink } from './linkText';
import { sharedContent, type ShareOptions } from './sharedContent';

/** Longest link (characters) that browsers, messengers and mail servers pass on unharmed. */
export const LINK_LIMIT = 64_000;

const kilobytes = (count: number): string => `${formatCount(Math.ceil(count / 1000))} kB`;

/**
 * The scene as URL hash.
 * @throws Error naming the size and the largest parts, when it is over the limit
 */
export async function linkHash(scene: Scene, options?: ShareOptions): Promise<string> {
  const content = sharedContent(scene, options);
  const largest = [...content.files].toSorted((a, b) => b[1].size - a[1].size).slice(0, 3);
  const bytes = largest.reduce((sum, [, { size }]) => sum + size, 0);
  const named = new Map(content.file.assets.map(({ name, file }) => [file, name]));
  const names = largest.map(([path, { size }]) => `${shortText(named.get(path)!)} (${kilobytes(size)})`);
  const why = names.length > 0 ? t(' The largest assets are {names}.', { names: names.join(', ') }) : '';
  const refuse = (size: number): never => {
    const limit = kilobytes(LINK_LIMIT);
    throw new Error(
      t('The link would have {size}, and {limit} is the limit.{why} Export a web page instead.', {
        size: kilobytes(size),
        limit,
        why,
      }),
    );
  };
  // not compressed when far over the limit, since images and models hardly shrink
  if (bytes > LINK_LIMIT * 4) refuse((bytes * 4) / 3);
  const hash = await encodeLink(JSON.stringify(await inlineAssets(content)));
  return hash.length > LINK_LIMIT ? refuse(hash.length) : hash;
}
