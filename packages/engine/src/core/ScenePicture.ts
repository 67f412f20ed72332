import { describeValue } from '@farol/editing/fields';

/** Thumbnail of a scene, shown by editors for its file. */
export interface ScenePicture {
  /** The picture as a `data:` address: WebP, JPEG or PNG. */
  readonly url: string;
  /** True for a picture that the user chose: saving does not replace it. */
  readonly chosen?: true;
}

/** Longest address of a picture (characters): about 48 kB of bytes. */
export const LONGEST_PICTURE = 65_536;

/** Problem of a picture's address, as a sentence without its subject; null for none. */
export function pictureProblem(url: unknown): string | null {
  if (typeof url !== 'string' || !/^data:image\/(webp|jpeg|png);base64,[\w+/]+=*$/.test(url))
    return `must be a WebP, JPEG or PNG as "data:image/…;base64,…", not ${describeValue(url)}.`;
  return url.length <= LONGEST_PICTURE
    ? null
    : `has ${url.length} characters; at most ${LONGEST_PICTURE}: make it smaller.`;
}
