import type { AssetType, FieldValue } from '@farol/editing/fields';
import type { PhotometricProfile } from '@farol/renderer/light-profiles';
import type { BufferGeometry, Material, ShaderMaterial, Texture } from 'three';
import type { BakedLight } from './bake/BakedLight';
import type { FieldAsset, FieldAssetType } from './FieldAsset';
import type { Model, ModelClip } from './Model';
import type { Sound } from './Sound';

/** Loaded form of an asset: an object of three's (for a shader, ShaderMaterial or RawShaderMaterial), or of Farol's. */
export type Asset =
  | BufferGeometry
  | Texture
  | Material
  | ShaderMaterial
  | Model
  | ModelClip
  | FieldAsset
  | Sound
  | PhotometricProfile
  | BakedLight;

/** A part of an asset that is decoded: a texture, the pictures of a model, a sound. */
export interface DecodedPart {
  /** Decoded size of the part (bytes). */
  readonly bytes: number;
  /** Texture, when the part is one; textures read from equal bytes share one image. */
  readonly texture?: Promise<Texture>;
}

/** Memory account of an asset that is read from a file, in bytes. */
export interface AssetMemory {
  /** Size of the asset's file (bytes); 0 until known. */
  file: number;
  /** Decoded parts, by a key of their content. */
  readonly decoded: Map<string, DecodedPart>;
}

/** Source of an asset: a value, a maker, or a loader. */
export type AssetSource =
  | {
      readonly type: AssetType;
      readonly make: () => Asset;
      readonly partOf?: string;
      /** Whether the asset is made by code: needs no file, and users cannot delete it. */
      readonly isBuiltin?: boolean;
      /** The asset as fields, when it can be edited. */
      readonly edited?: FieldAsset;
    }
  | {
      readonly type: AssetType;
      readonly load: (signal?: AbortSignal) => Promise<Asset>;
      readonly url?: string;
      readonly file?: Blob;
      readonly memory?: AssetMemory;
      readonly partOf?: string;
    };

/** A file added to a library; the asset of this name is read from its bytes. */
export interface AssetFile {
  readonly name: string;
  readonly type: AssetType;
  readonly blob: Blob;
}

/** Asset removed by `AssetLibrary.take`, for `AssetLibrary.restore` to put back. */
export interface TakenAsset {
  readonly name: string;
  readonly source: AssetSource;
  readonly value: Asset | undefined;
  readonly parts: readonly TakenAsset[];
}

/** Change of an asset library, the argument of its listeners. */
export type AssetChange =
  | {
      readonly kind: 'registered' | 'loaded' | 'failed' | 'removed';
      readonly name: string;
      readonly type: AssetType;
      readonly error?: Error;
    }
  /** A folder of assets was added or removed. */
  | { readonly kind: 'folder'; readonly name: string; readonly error?: undefined }
  /** A field of a field asset changed; `before` is the old value. */
  | {
      readonly kind: 'changed';
      readonly name: string;
      readonly type: FieldAssetType;
      readonly asset: FieldAsset;
      readonly field: string;
      readonly before: FieldValue;
      readonly error?: undefined;
    };

/** Component that uses a material of a library. */
export interface MaterialUser {
  /** Called when three's material was replaced: the component gets it from the library again. */
  materialReplaced(): void;
}

/** Type of a loaded asset. */
export function assetTypeOf(asset: Asset): AssetType {
  if ('isModel' in asset) return 'model';
  if ('isFieldAsset' in asset) return asset.type;
  if ('isSound' in asset) return 'sound';
  if ('isPhotometricProfile' in asset) return 'profile';
  if ('isBakedLight' in asset) return 'bake';
  if ('isModelClip' in asset) return 'clip';
  if ('isBufferGeometry' in asset) return 'mesh';
  if ('isTexture' in asset) return 'texture';
  return 'isShaderMaterial' in asset ? 'shader' : 'material';
}
