import type { FieldValue } from '../fields/Field';
import type { Component } from './Component';
import type { GameObject } from './GameObject';

/** What an edit changed. Simulation makes none of these. */
export type SceneChange =
  | { readonly kind: 'add' | 'remove' | 'move'; readonly gameObject: GameObject }
  | {
      readonly kind: 'object';
      readonly gameObject: GameObject;
      readonly property: 'name' | 'active' | 'locked' | 'tags' | 'prefab';
    }
  | {
      readonly kind: 'component-add' | 'component-remove' | 'component-move';
      readonly gameObject: GameObject;
      readonly component: Component;
    }
  | {
      readonly kind: 'field';
      readonly component: Component;
      readonly field: string;
      /** The authored value until then. */
      readonly before: FieldValue;
    }
  | { readonly kind: 'enabled'; readonly component: Component }
  | { readonly kind: 'settings'; readonly field: string; readonly before: FieldValue }
  | { readonly kind: 'microshader'; readonly name: string }
  | { readonly kind: 'prefab'; readonly id: string }
  | { readonly kind: 'active-camera' | 'name' };
