import type { AssetType, FieldValue } from '@farol/editing/fields';
import type { FileObject } from '../core/FileObject';
import type { Prefab } from '../core/Prefab';
import type { ScenePicture } from '../core/ScenePicture';
import type { SceneView } from '../core/SceneViews';

export type { FileComponent, FileObject, PrefabLink } from '../core/FileObject';
export type { Prefab } from '../core/Prefab';

/**
 * Version of the file format. Raise it, and add to `fileMigrations`, when the shape below changes.
 *
 * 1: settings, assets by address, objects. 2: prefabs, links of objects to them, assets inside the file. 3: scripts,
 * clips and sounds.
 */
export const FILE_VERSION = 3;

/**
 * Asset in a scene file: read from an address (`url`), from a file in the `.farol` container (`file`), or made of field
 * values (`values`: a material, script or clip). Exactly one of the three is present.
 */
export interface FileAsset {
  /** Name of the asset with its folder: 'Props/robot.glb'. */
  name: string;
  type: AssetType;
  /** Address of the asset's file; a `data:` address contains the bytes. */
  url?: string;
  /** Path of the asset in the `.farol` container: 'assets/robot.glb'. */
  file?: string;
  /** Fields of a material, script or clip that differ from their defaults: see `fieldAssetFields`. */
  values?: Record<string, FieldValue>;
}

/** A camera bookmark for editors, at a place from 1 to 9; each place occurs once. */
export interface FileView extends SceneView {
  readonly place: number;
}

/** A scene as versioned JSON. Objects are in tree order, so siblings keep their order. */
export interface FarolFile {
  format: 'farol-scene';
  version: number;
  name: string;
  /** Fields of SceneSettings that differ from their defaults. */
  settings: Record<string, FieldValue>;
  /** Id of the GameObject with the active Camera, or null. */
  activeCamera: string | null;
  assets: FileAsset[];
  /** Paths of asset folders, also empty ones: 'Props/Lamps'. None when absent. */
  assetFolders?: string[];
  /**
   * Microshaders of the scene, which replace or add to the renderer's: text in the form of a `.glsl` file (see the
   * renderer's `parseMicroShader`) by name. None when absent.
   */
  microShaders?: Record<string, string>;
  /** Camera bookmarks of editors. None when absent. */
  views?: FileView[];
  /** Thumbnail of the scene for lists of files. None when absent. */
  picture?: ScenePicture;
  /** Prefabs of the scene; none when absent. */
  prefabs?: Prefab[];
  objects: FileObject[];
}
