import type { FieldValue } from '@farol/editing/fields';
import type { FieldAsset } from '../assets/FieldAsset';
import type { Component } from './Component';
import type { GameObject } from './GameObject';

/** A change by an edit, never by simulation. */
export type SceneChange =
  | { readonly kind: 'add' | 'remove' | 'move'; readonly gameObject: GameObject }
  | {
      readonly kind: 'object';
      readonly gameObject: GameObject;
      readonly property: 'name' | 'active' | 'locked' | 'static' | 'tags' | 'prefab';
    }
  | {
      readonly kind: 'component-add' | 'component-remove' | 'component-move';
      readonly gameObject: GameObject;
      readonly component: Component;
    }
  | {
      readonly kind: 'component-class';
      readonly gameObject: GameObject;
      /** Component that was replaced by `component`, with the same id and place, because its script was edited. */
      readonly before: Component;
      readonly component: Component;
    }
  | {
      readonly kind: 'field';
      readonly component: Component;
      readonly field: string;
      /** Authored value before the edit. */
      readonly before: FieldValue;
    }
  | { readonly kind: 'enabled'; readonly component: Component }
  | { readonly kind: 'settings'; readonly field: string; readonly before: FieldValue }
  | {
      /** A field of an asset of the library has changed. */
      readonly kind: 'asset';
      readonly asset: FieldAsset;
      readonly field: string;
      readonly before: FieldValue;
    }
  | { readonly kind: 'microshader'; readonly name: string }
  | { readonly kind: 'view'; readonly place: number }
  | { readonly kind: 'prefab'; readonly id: string }
  | { readonly kind: 'active-camera' | 'name' };
