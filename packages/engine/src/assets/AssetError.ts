import { shortText } from '@farol/editing';
/** Error for an asset that is unknown, of another type, not loaded yet, or that failed to load. */
export class AssetError extends Error {
  constructor(
    readonly asset: string,
    readonly problem: string,
    options?: ErrorOptions,
  ) {
    super(`The asset '${shortText(asset, 80)}' ${shortText(problem, 400)}`, options);
    this.name = 'AssetError';
  }
}
