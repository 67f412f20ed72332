import type { FarolRenderer, TechniqueName, View } from '@farol/renderer';
import { Signal, t } from '@farol/editing';
import type { PictureRenderer } from '@farol/engine';
import type { EditorDocument } from '../model/EditorDocument';
import { setValues } from '../model/edits';
import type { FrameLoop } from './FrameLoop';
import type { Gizmo, GizmoMode, GizmoPivot, GizmoSpace } from './Gizmo';
import type { SnapTarget } from './handles/DragSnap';
import type { Helpers } from './Helpers';

/** Names of the settings, by the object that stores them. */
const held = {
  gizmo: ['mode', 'space', 'snapping', 'snapTo', 'alignsToSurface', 'pivot'],
  helpers: ['showGrid', 'showIcons', 'showRanges'],
  shown: ['showColliders', 'showStatistics'],
  loop: ['continuous'],
  farol: ['view'],
} as const;

/** Settings of the viewport and its handles; each change emits `changed`. */
export abstract class ViewportSettings {
  /** Emits when one of the settings, or the view, changes. */
  readonly changed = new Signal();

  abstract readonly document: EditorDocument;
  abstract readonly farol: FarolRenderer;
  abstract readonly picture: PictureRenderer;
  abstract readonly gizmo: Gizmo;
  abstract readonly helpers: Helpers;
  protected abstract readonly loop: FrameLoop;
  protected readonly shown = { showColliders: false, showStatistics: false };

  declare mode: GizmoMode;
  declare space: GizmoSpace;
  declare snapping: boolean;
  /** Target that drags snap to while snapping is on. */
  declare snapTo: SnapTarget;
  /** Whether objects dropped on a surface are rotated so that their y axis is the surface normal. */
  declare alignsToSurface: boolean;
  declare pivot: GizmoPivot;
  declare showGrid: boolean;
  declare showIcons: boolean;
  /** Whether ranges of all lights are drawn, or only of selected ones. */
  declare showRanges: boolean;
  /** Whether colliders and joints of all objects are drawn, or only of selected ones. */
  declare showColliders: boolean;
  /** Whether every frame is drawn, changed or not, to measure frame rates. */
  declare continuous: boolean;
  declare showStatistics: boolean;
  declare view: View;

  /** Whether the scene's bloom, depth of field, grading and vignette are drawn. */
  get showPictureEffects(): boolean {
    return this.picture.showsEffects;
  }

  set showPictureEffects(show: boolean) {
    this.picture.showsEffects = show;
    this.changed.emit();
  }

  get technique(): TechniqueName {
    return this.farol.technique;
  }

  /**
   * Technique of the scene; setting it is a step of history. @throws Error when there is no such technique, or the
   * device lacks what it needs
   */
  set technique(technique: TechniqueName) {
    const { settings } = this.document.scene;
    this.farol.technique = technique;
    const name = t(this.farol.techniques[technique].label);
    this.document.commands.run(setValues(t('Set technique to {name}', { name }), [settings], { technique }));
    this.changed.emit();
  }

  /** Sets the number per pixel, of lights or of surfaces drawn, at which heat maps have their hottest colour. */
  setHeatMapMaximum(maximum: number): void {
    this.farol.heatMapMaximum = maximum;
    this.changed.emit();
  }
}

for (const [holder, names] of Object.entries(held)) {
  for (const name of names) {
    Object.defineProperty(ViewportSettings.prototype, name, {
      get(this: Record<string, Record<string, unknown>>) {
        return this[holder][name];
      },
      set(this: Record<string, Record<string, unknown>> & ViewportSettings, value: unknown) {
        this[holder][name] = value;
        this.changed.emit();
      },
    });
  }
}
