import { t } from '@farol/editing';
import { FileError, type MayUnpack, unpack } from '@farol/engine/files';
import { isLink, PREFIX } from './isLink';

async function through(
  bytes: Uint8Array<ArrayBuffer>,
  stream: GenericTransformStream,
): Promise<Uint8Array<ArrayBuffer>> {
  return new Uint8Array(await new Response(new Blob([bytes]).stream().pipeThrough(stream)).arrayBuffer());
}

/** A text as URL hash: '#scene=' and base64url of its deflated bytes. @see RFC 4648, section 5 */
export async function encodeLink(text: string): Promise<string> {
  const packed = await through(new TextEncoder().encode(text), new CompressionStream('deflate-raw'));
  let letters = '';
  for (let i = 0; i < packed.length; i += 0x8000) letters += String.fromCharCode(...packed.subarray(i, i + 0x8000));
  return PREFIX + btoa(letters).replaceAll('+', '-').replaceAll('/', '_').replaceAll('=', '');
}

/**
 * Decodes a URL hash.
 * @param mayUnpack - asked before the text grows large; a large one is refused when absent
 * @throws Error when there is no scene, it was truncated, or it is too large; AbortError when `mayUnpack` refused
 */
export async function decodeLink(hash: string, mayUnpack?: MayUnpack): Promise<string> {
  if (!isLink(hash)) throw new Error(t('The address has no scene in it: it must end with #scene=…'));
  try {
    const base64 = hash.slice(PREFIX.length).replaceAll('-', '+').replaceAll('_', '/');
    const bytes = Uint8Array.from(atob(base64), (letter) => letter.charCodeAt(0));
    return new TextDecoder().decode(await unpack(bytes, 'deflate-raw', { mayUnpack }));
  } catch (cause) {
    if (cause instanceof FileError || (cause instanceof DOMException && cause.name === 'AbortError')) throw cause;
    throw new Error(t('The link is damaged or cut short: copy all of it, to its last letter.'), { cause });
  }
}
