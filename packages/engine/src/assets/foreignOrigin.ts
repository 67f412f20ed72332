import { shortText } from '@farol/editing';
import { AssetError } from './AssetError';

/** Base of relative addresses where there is no page, as in Node. */
const NOWHERE = 'http://here.invalid/';

/**
 * The origin of an address, if it differs from the page's: 'https://example.com', or scheme and host if there is no
 * origin, 'file://server'. Null for the page's own origin, `data:`, `blob:` and invalid addresses.
 * @param base - address of the page; the document's when absent
 */
export function foreignOrigin(url: string, base: string = globalThis.document?.baseURI ?? NOWHERE): string | null {
  let address: URL;
  let page: URL;
  try {
    page = new URL(base);
    address = new URL(url, page);
  } catch {
    return null;
  }
  const { protocol, host, origin } = address;
  if (protocol === 'data:' || protocol === 'blob:') return null;
  if (protocol === page.protocol && host === page.host) return null;
  return origin === 'null' ? `${protocol}//${host}` : origin;
}

/** Error for an asset that was not fetched, since the scene may not use the origin of its address. */
export class AddressRefusedError extends AssetError {
  /** @param origin - see `foreignOrigin` */
  constructor(
    asset: string,
    readonly url: string,
    readonly origin: string,
  ) {
    super(asset, `was not fetched: ${shortText(origin, 80)} is not allowed. Open the scene again and allow it.`);
    this.name = 'AddressRefusedError';
  }
}
