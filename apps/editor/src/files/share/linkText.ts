import { t } from '@farol/editing';
import { FileError, type MayUnpack, unpack } from '@farol/engine/files';
import { isLink, PREFIX } from './isLink';

async function through(
  bytes: Uint8Array<ArrayBuffer>,
  stream: GenericTransformStream,
): Promise<Uint8Array<ArrayBuffer>> {
  return new Uint8Array(await new Response(new Blob([bytes]).stream().pipeThrough(stream)).arrayBuffer());
}

/** A text, deflated and as base64 for addresses, after '#scene='. @see RFC 4648, section 5 */
export async function encodeLink(text: string): Promise<string> {
  const packed = await through(new TextEncoder().encode(text), new CompressionStream('deflate-raw'));
  let letters = '';
  for (let i = 0; i < packed.length; i += 0x8000) letters += String.fromCharCode(...packed.subarray(i, i + 0x8000));
  return PREFIX + btoa(letters).replaceAll('+', '-').replaceAll('/', '_').replaceAll('=', '');
}

/**
 * The text of a link.
 * @param mayUnpack - asked before it becomes large; such a one is refused when absent
 * @throws Error when there is none, it was cut short on its way, or it becomes too large; AbortError when the answer was no
 */
export async function decodeLink(hash: string, mayUnpack?: MayUnpack): Promise<string> {
  if (!isLink(hash)) throw new Error(t('The address holds no scene: it must go on with #scene=…'));
  try {
    const base64 = hash.slice(PREFIX.length).replaceAll('-', '+').replaceAll('_', '/');
    const bytes = Uint8Array.from(atob(base64), (letter) => letter.charCodeAt(0));
    return new TextDecoder().decode(await unpack(bytes, 'deflate-raw', { mayUnpack }));
  } catch (cause) {
    if (cause instanceof FileError || (cause instanceof DOMException && cause.name === 'AbortError')) throw cause;
    throw new Error(t('The link is damaged or cut short: copy all of it, to its last letter.'), { cause });
  }
}
