import type { FieldValue } from '@farol/editing/fields';

/** A component in a file. Fields that have their default are left out. */
export interface FileComponent {
  type: string;
  /** Version of the component's class that wrote it. */
  version: number;
  id: string;
  /** Whether the component is enabled; true when absent. */
  enabled?: boolean;
  values: Record<string, FieldValue>;
}

/** A GameObject in a file. */
export interface FileObject {
  id: string;
  name: string;
  /** Id of the parent object, or null at the top. */
  parent: string | null;
  /** Whether the GameObject is active; true when absent. */
  active?: boolean;
  /** Whether editors exclude the object from picking; false when absent. */
  locked?: boolean;
  /** Whether the object's meshes get baked lightmaps; false when absent. */
  static?: boolean;
  tags?: string[];
  /** Link to the prefab's object that the object is a copy of; absent outside prefab instances. */
  prefab?: PrefabLink;
  components: FileComponent[];
}

/** Link of a GameObject to the object of a prefab that it is a copy of. */
export interface PrefabLink {
  readonly prefab: string;
  /** Id of the object in the prefab; the prefab's own id for the root of an instance. */
  readonly source: string;
  /**
   * Overrides whose value equals the prefab's at present: 'Light.intensity', 'name'. They remain overrides when the
   * prefab changes. Every other value that differs from the prefab's is an override without being listed.
   */
  readonly pinned?: readonly string[];
}
