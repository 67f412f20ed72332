import type { Light, Object3D } from 'three';

type Drawn = Object3D & { isMesh?: boolean; isLine?: boolean; isPoints?: boolean };

/**
 * Which lights reach which objects when a light reaches only what shares a layer with it: the sets of layers that objects
 * have, the most frequent of them, and whether any light tells them apart. Ambient and hemisphere lights reach all.
 */
export class LightLayers {
  /** Layers of most objects, as a mask; 0 when no light of the frame tells objects apart. */
  reference = 0;
  private enabled = false;
  private readonly masks: number[] = [];
  private readonly counts: number[] = [];
  private met = false;

  /** Begins a frame: looks at what the scene's objects have, if lights are to tell them apart. */
  begin(root: Object3D, enabled: boolean): void {
    this.enabled = enabled;
    this.masks.length = this.counts.length = 0;
    this.met = false;
    this.reference = 0;
    if (enabled && root.visible) this.visit(root);
  }

  /** True for a light that reaches some of the objects and not others, or none. */
  separates(light: Light): boolean {
    if (!this.enabled) return false;
    for (const mask of this.masks) {
      if ((mask & light.layers.mask) !== 0) continue;
      this.met = true;
      return true;
    }
    return false;
  }

  /** Ends the look at the lights. */
  end(): void {
    if (!this.met) return;
    let most = 0;
    for (let i = 0; i < this.masks.length; i++) {
      if (this.counts[i] <= most) continue;
      most = this.counts[i];
      this.reference = this.masks[i];
    }
  }

  private visit(object: Object3D): void {
    const drawn = object as Drawn;
    if (drawn.isMesh || drawn.isLine || drawn.isPoints) {
      const { mask } = object.layers;
      const i = this.masks.indexOf(mask);
      if (i >= 0) this.counts[i]++;
      else {
        this.masks.push(mask);
        this.counts.push(1);
      }
    }
    const { children } = object;
    for (let i = 0; i < children.length; i++) if (children[i].visible) this.visit(children[i]);
  }
}
