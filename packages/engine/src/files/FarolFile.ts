import type { AssetType, FieldValue } from '@farol/editing/fields';
import type { SceneView } from '../core/SceneViews';

/**
 * Version of the file format. Raise it, and add to `fileMigrations`, when the shape below changes.
 *
 * 1: settings, assets by address, objects. 2: prefabs, links of objects to them, assets inside the file. 3: scripts, clips
 * and sounds.
 */
export const FILE_VERSION = 3;

/** A component in a file. Fields that have their default are left out. */
export interface FileComponent {
  type: string;
  /** Version of the component's class that wrote it. */
  version: number;
  id: string;
  /** True when absent. */
  enabled?: boolean;
  values: Record<string, FieldValue>;
}

/** A GameObject in a file. */
export interface FileObject {
  id: string;
  name: string;
  /** Id of the object above, or null at the top. */
  parent: string | null;
  /** True when absent. */
  active?: boolean;
  /** Left alone by editors; false when absent. */
  locked?: boolean;
  /** Gets a lightmap when light is baked; false when absent. */
  static?: boolean;
  tags?: string[];
  /** What it is a copy of; of no prefab when absent. */
  prefab?: PrefabLink;
  components: FileComponent[];
}

/** A tree of objects to be placed any number of times. It is data: nothing of it is drawn. Never changed in place. */
export interface Prefab {
  /** Also the id of its root object. */
  readonly id: string;
  readonly name: string;
  /** In tree order; the root, which has no parent, is the first. Those of another prefab within it have a link to that. */
  readonly objects: readonly FileObject[];
}

/** What a GameObject is a copy of. */
export interface PrefabLink {
  readonly prefab: string;
  /** Id of the object in the prefab; the prefab's own id for the root of an instance. */
  readonly source: string;
  /**
   * Overrides that happen to have the prefab's present value: 'Light.intensity', 'name'. They stay when it changes. Every
   * other value that differs from the prefab's is an override without being listed.
   */
  readonly pinned?: readonly string[];
}

/**
 * An asset that is read from an address, or from a file beside the scene in a `.farol` container, or is made of
 * fields (a material, script or clip): one of the three.
 */
export interface FileAsset {
  /** With its folder: 'Props/robot.glb'. */
  name: string;
  type: AssetType;
  /** An address; `data:` holds the bytes themselves. */
  url?: string;
  /** Path in the container: 'assets/robot.glb'. */
  file?: string;
  /** Of a material, script or clip: the fields that differ from their defaults, see `fieldAssetFields`. */
  values?: Record<string, FieldValue>;
}

/** A view of the scene that editors keep, in a place from 1 to 9, each of which is taken once. */
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
  /** Id of the GameObject whose Camera is looked through, or null. */
  activeCamera: string | null;
  assets: FileAsset[];
  /** Folders of assets that are there without an asset in them too, by path: 'Props/Lamps'. None when absent. */
  assetFolders?: string[];
  /**
   * Microshaders of the scene, in place of the renderer's own or besides them: text in the form of a `.glsl` file (see
   * the renderer's `parseMicroShader`) by name. None when absent.
   */
  microShaders?: Record<string, string>;
  /** Views that editors keep, by their places. None when absent. */
  views?: FileView[];
  /** None when absent. */
  prefabs?: Prefab[];
  objects: FileObject[];
}
