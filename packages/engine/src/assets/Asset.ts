import type { BufferGeometry, Material, ShaderMaterial, Texture } from 'three';
import type { AssetType } from '../fields/Field';

/** What an asset is in three. A shader is a ShaderMaterial or RawShaderMaterial, used as it is. */
export type Asset = BufferGeometry | Texture | Material | ShaderMaterial;

/** How an asset comes to be: at once, or after loading. */
export type AssetSource =
  | { readonly type: AssetType; readonly make: () => Asset }
  | { readonly type: AssetType; readonly load: () => Promise<Asset>; readonly url?: string };

/** Something that happened to an asset of a library. */
export interface AssetChange {
  readonly kind: 'registered' | 'loaded' | 'failed' | 'removed';
  readonly name: string;
  readonly type: AssetType;
  readonly error?: Error;
}

/** The type of a three resource. */
export function assetTypeOf(asset: Asset): AssetType {
  if ('isBufferGeometry' in asset) return 'mesh';
  if ('isTexture' in asset) return 'texture';
  return 'isShaderMaterial' in asset ? 'shader' : 'material';
}
