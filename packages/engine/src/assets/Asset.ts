import type { AssetType, FieldValue } from '@farol/editing/fields';
import type { PhotometricProfile } from '@farol/renderer/light-profiles';
import type { BufferGeometry, Material, ShaderMaterial, Texture } from 'three';
import type { BakedLight } from './bake/BakedLight';
import type { FieldAsset, FieldAssetType } from './FieldAsset';
import type { Model, ModelClip } from './Model';
import type { Sound } from './Sound';

/**
 * Loaded form of an asset: an object of three's. A shader is a ShaderMaterial or RawShaderMaterial, used as it is;
 * scripts and clips are data.
 */
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
  /** Memory that it takes (bytes). */
  readonly bytes: number;
  /** The texture, when the asset is one; assets of equal bytes share its image. */
  readonly texture?: Promise<Texture>;
}

/** Memory of an asset that is read from a file, in bytes. */
export interface AssetMemory {
  /** Bytes of its file; 0 before they are known. */
  file: number;
  /** By their content. */
  readonly decoded: Map<string, DecodedPart>;
}

/** How an asset comes to be: at once, or after loading. */
export type AssetSource =
  | {
      readonly type: AssetType;
      readonly make: () => Asset;
      readonly partOf?: string;
      /** Made by code that a page has anyway: needs no file, and is not a user's to delete. */
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

/** A file that a library has taken in: the asset of this name is read from its bytes. */
export interface AssetFile {
  /** Name of the asset. */
  readonly name: string;
  readonly type: AssetType;
  readonly blob: Blob;
}

/** Asset that `AssetLibrary.take` took out; `AssetLibrary.restore` puts it back. */
export interface TakenAsset {
  readonly name: string;
  readonly source: AssetSource;
  readonly value: Asset | undefined;
  readonly parts: readonly TakenAsset[];
}

/** Something that happened to an asset of a library. */
export type AssetChange =
  | {
      readonly kind: 'registered' | 'loaded' | 'failed' | 'removed';
      readonly name: string;
      readonly type: AssetType;
      readonly error?: Error;
    }
  /** A folder came or went. */
  | { readonly kind: 'folder'; readonly name: string; readonly error?: undefined }
  /** A field of an asset that is made of fields got another value; `before` is the value until then. */
  | {
      readonly kind: 'changed';
      readonly name: string;
      readonly type: FieldAssetType;
      readonly asset: FieldAsset;
      readonly field: string;
      readonly before: FieldValue;
      readonly error?: undefined;
    };

/** Something that draws with a material of a library. */
export interface MaterialUser {
  /** The material has become another one for three: it is to be asked for again. */
  materialReplaced(): void;
}

/** The type of a three resource. */
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
