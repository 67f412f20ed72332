import type { Component } from './Component';
import type { GameObject } from './GameObject';

/** What an edit changed. Simulation makes none of these. */
export type SceneChange =
  | { readonly kind: 'add' | 'remove' | 'move'; readonly gameObject: GameObject }
  | { readonly kind: 'object'; readonly gameObject: GameObject; readonly property: 'name' | 'active' | 'tags' }
  | {
      readonly kind: 'component-add' | 'component-remove' | 'component-move';
      readonly gameObject: GameObject;
      readonly component: Component;
    }
  | { readonly kind: 'field'; readonly component: Component; readonly field: string }
  | { readonly kind: 'enabled'; readonly component: Component }
  | { readonly kind: 'settings'; readonly field: string }
  | { readonly kind: 'active-camera' | 'name' };
