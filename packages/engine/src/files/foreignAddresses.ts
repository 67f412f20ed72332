import { foreignOrigin } from '../assets/foreignOrigin';
import type { FarolFile } from './FarolFile';

/** An address of another origin in a scene file. */
export interface ForeignAddress {
  /** Name of the asset at the address. */
  readonly asset: string;
  readonly url: string;
  /** Origin that the user must allow: 'https://example.com'. */
  readonly origin: string;
}

/**
 * The addresses in a scene, but for `data:` and `blob:`, whose origin or scheme is not the page's, to be checked before
 * a fetch. Models add none: a model read from an address or from the file must be self-contained.
 * @param file - result of `parseFile`; prefabs, materials and microshaders name assets, not addresses
 * @param base - address of the page; the document's when absent
 */
export function foreignAddresses(file: Pick<FarolFile, 'assets'>, base?: string): ForeignAddress[] {
  return file.assets.flatMap(({ name, url }) => {
    const origin = url === undefined ? null : foreignOrigin(url, base);
    return url !== undefined && origin !== null ? [{ asset: name, url, origin }] : [];
  });
}
