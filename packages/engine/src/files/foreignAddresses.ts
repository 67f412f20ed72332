import { foreignOrigin } from '../assets/foreignOrigin';
import type { FarolFile } from './FarolFile';

/** An address in a scene file that leads away from the page. */
export interface ForeignAddress {
  /** Name of the asset at the address. */
  readonly asset: string;
  readonly url: string;
  /** Origin that the user is asked about: 'https://example.com'. */
  readonly origin: string;
}

/**
 * Every address in a scene that leads to another origin, or by another scheme than the page's, `data:` and `blob:`,
 * before any of it is fetched. Models cannot name more: those that are read from an address or from the file must be
 * whole.
 * @param file - checked, as `parseFile` gives it: prefabs, materials and microshaders name assets only
 * @param base - address of the page; the document's when absent
 */
export function foreignAddresses(file: Pick<FarolFile, 'assets'>, base?: string): ForeignAddress[] {
  return file.assets.flatMap(({ name, url }) => {
    const origin = url === undefined ? null : foreignOrigin(url, base);
    return url !== undefined && origin !== null ? [{ asset: name, url, origin }] : [];
  });
}
