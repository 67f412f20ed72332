import type { FieldValue } from '@farol/editing/fields';
import type { Component } from '../core/Component';
import type { GameObject } from '../core/GameObject';
import type { PrefabLink } from '../core/Prefab';

/** One edit of an instance, to follow its prefab; editors turn edits into undoable commands. */
export type PrefabEdit =
  | { readonly kind: 'field'; readonly component: Component; readonly field: string; readonly value: FieldValue }
  | { readonly kind: 'enabled'; readonly component: Component; readonly value: boolean }
  | { readonly kind: 'name'; readonly object: GameObject; readonly value: string }
  | { readonly kind: 'active' | 'static'; readonly object: GameObject; readonly value: boolean }
  | { readonly kind: 'tags'; readonly object: GameObject; readonly value: readonly string[] }
  | { readonly kind: 'link'; readonly object: GameObject; readonly value: PrefabLink | null }
  | { readonly kind: 'add-component'; readonly object: GameObject; readonly component: Component; readonly id: string }
  | { readonly kind: 'remove-component'; readonly object: GameObject; readonly component: Component }
  /** Appends the new `object`, not yet in a scene, to the parent's children. */
  | { readonly kind: 'add-object'; readonly object: GameObject; readonly parent: GameObject }
  | { readonly kind: 'remove-object'; readonly object: GameObject }
  /** Moves an object in the tree; its local transform stays. */
  | { readonly kind: 'move-object'; readonly object: GameObject; readonly parent: GameObject };

/** Applies one edit of a plan to the objects of a scene. */
export function applyPrefabEdit(edit: PrefabEdit): void {
  switch (edit.kind) {
    case 'field':
      edit.component.set(edit.field, edit.value);
      break;
    case 'enabled':
      edit.component.enabled = edit.value;
      break;
    case 'name':
      edit.object.name = edit.value;
      break;
    case 'active':
      edit.object.active = edit.value;
      break;
    case 'static':
      edit.object.isStatic = edit.value;
      break;
    case 'tags':
      edit.object.tags = edit.value;
      break;
    case 'link':
      edit.object.prefabLink = edit.value;
      break;
    case 'add-component':
      edit.object.addComponent(edit.component, {}, { id: edit.id, enabled: edit.component.enabled });
      break;
    case 'remove-component':
      edit.object.removeComponent(edit.component);
      break;
    case 'add-object':
    case 'move-object':
      edit.parent.add(edit.object);
      break;
    case 'remove-object':
      (edit.object.parent ?? edit.object.scene)?.remove(edit.object);
      break;
  }
}
