import type { AssetType, FieldValue } from '@farol/editing/fields';
import { type AssetNames, FieldOwner } from '../fields/FieldOwner';

/** Types of assets that are defined by fields, and edited as components are. */
export type FieldAssetType = Extract<AssetType, 'material' | 'script' | 'clip' | 'surface'>;

/** Part of an AssetLibrary that its field assets use. */
export interface FieldAssetHost extends AssetNames {
  /** @internal Called after a field changed. @param isReplaced - three's material is another object now */
  fieldAssetChanged(asset: FieldAsset, field: string, before: FieldValue, isReplaced: boolean): void;
}

/**
 * Asset of a library that is defined by fields: files store its values, and the commands that edit components edit it.
 */
export abstract class FieldAsset extends FieldOwner {
  readonly isFieldAsset = true;
  abstract readonly type: FieldAssetType;

  /** Name of the asset in its library. */
  name: string;

  protected constructor(name: string) {
    super();
    this.name = name;
  }

  override get ownerName(): string {
    return this.name ?? '';
  }

  /** Frees GPU memory; the asset may be used again. */
  abstract dispose(): void;
}

/** A field asset that is data, not a resource of three's. */
export abstract class DataAsset extends FieldAsset {
  private host: FieldAssetHost | null = null;

  /** @throws FieldError for a value that is not allowed */
  constructor(host: FieldAssetHost, name: string, values: Readonly<Record<string, FieldValue>> = {}) {
    super(name);
    for (const field of Object.keys(values)) this.set(field, values[field]);
    this.host = host;
  }

  override dispose(): void {}

  protected override get assetNames(): AssetNames | null {
    return this.host;
  }

  protected override fieldChanged(name: string, before: FieldValue): void {
    this.host?.fieldAssetChanged(this, name, before, false);
  }
}
