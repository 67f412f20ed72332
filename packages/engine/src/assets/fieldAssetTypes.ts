import type { FieldTable } from '@farol/editing/fields';
import { clipFields } from './clips/ClipAsset';
import type { FieldAssetType } from './FieldAsset';
import { materialAssetFields } from './materialAssetFields';
import { scriptFields } from './ScriptAsset';
import { surfaceFields } from './SurfaceAsset';

/** Field table of each type of asset that is defined by fields. */
export const fieldAssetFields: { readonly [T in FieldAssetType]: FieldTable } = {
  material: materialAssetFields,
  script: scriptFields,
  clip: clipFields,
  surface: surfaceFields,
};

/** Whether assets of a type are defined by fields. */
export const isFieldAssetType = (type: unknown): type is FieldAssetType =>
  typeof type === 'string' && Object.hasOwn(fieldAssetFields, type);
