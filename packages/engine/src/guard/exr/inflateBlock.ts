import { unpack } from '../unpack';

/**
 * Unpacks a block, or a part of one.
 * @param size - unpacked size (bytes): `exact`, or `most` for an upper limit
 * @throws Error (as a rejection) when the block is damaged or of another size
 */
export async function inflateBlock(
  bytes: Uint8Array<ArrayBuffer>,
  size: { readonly exact: number } | { readonly most: number },
): Promise<Uint8Array<ArrayBuffer>> {
  try {
    return await unpack(bytes, 'deflate', size);
  } catch (cause) {
    throw new Error('a block of it is damaged, or becomes more than it may', { cause });
  }
}
