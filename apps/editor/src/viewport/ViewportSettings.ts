import type { FarolRenderer, TechniqueName, View } from '@farol/renderer';
import { Signal, t } from '@farol/editing';
import type { PictureRenderer } from '@farol/engine';
import type { EditorDocument } from '../model/EditorDocument';
import { setValues } from '../model/edits';
import type { FrameLoop } from './FrameLoop';
import type { Gizmo, GizmoMode, GizmoPivot, GizmoSpace } from './Gizmo';
import type { SnapTarget } from './handles/DragSnap';
import type { Helpers } from './Helpers';

/** Settings of the viewport and its handles; each change emits. */
export abstract class ViewportSettings {
  /** Emits when one of the settings, or the view, changes. */
  readonly changed = new Signal();

  abstract readonly document: EditorDocument;
  abstract readonly farol: FarolRenderer;
  abstract readonly picture: PictureRenderer;
  abstract readonly gizmo: Gizmo;
  abstract readonly helpers: Helpers;
  protected abstract readonly loop: FrameLoop;
  private hasStatistics = false;
  private hasColliders = false;

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

  get view(): View {
    return this.farol.view;
  }

  set view(view: View) {
    this.farol.view = view;
    this.changed.emit();
  }

  /** Sets the number of lights, or draws, per pixel at which heat maps are hottest. */
  setHeatMapMaximum(maximum: number): void {
    this.farol.heatMapMaximum = maximum;
    this.changed.emit();
  }

  get mode(): GizmoMode {
    return this.gizmo.mode;
  }

  set mode(mode: GizmoMode) {
    this.gizmo.mode = mode;
    this.changed.emit();
  }

  get space(): GizmoSpace {
    return this.gizmo.space;
  }

  set space(space: GizmoSpace) {
    this.gizmo.space = space;
    this.changed.emit();
  }

  get snapping(): boolean {
    return this.gizmo.snapping;
  }

  set snapping(snapping: boolean) {
    this.gizmo.snapping = snapping;
    this.changed.emit();
  }

  /** Target of drags while snapping. */
  get snapTo(): SnapTarget {
    return this.gizmo.snapTo;
  }

  set snapTo(target: SnapTarget) {
    this.gizmo.snapTo = target;
    this.changed.emit();
  }

  /** Whether objects dropped on a surface are rotated so that their y axis is the surface normal. */
  get alignsToSurface(): boolean {
    return this.gizmo.alignsToSurface;
  }

  set alignsToSurface(aligns: boolean) {
    this.gizmo.alignsToSurface = aligns;
    this.changed.emit();
  }

  /** Point that several objects rotate and scale about. */
  get pivot(): GizmoPivot {
    return this.gizmo.pivot;
  }

  set pivot(pivot: GizmoPivot) {
    this.gizmo.pivot = pivot;
    this.changed.emit();
  }

  get showGrid(): boolean {
    return this.helpers.showGrid;
  }

  set showGrid(show: boolean) {
    this.helpers.showGrid = show;
    this.changed.emit();
  }

  get showIcons(): boolean {
    return this.helpers.showIcons;
  }

  set showIcons(show: boolean) {
    this.helpers.showIcons = show;
    this.changed.emit();
  }

  /** Whether the scene's bloom, depth of field, grading and vignette are drawn. */
  get showPictureEffects(): boolean {
    return this.picture.showsEffects;
  }

  set showPictureEffects(show: boolean) {
    this.picture.showsEffects = show;
    this.changed.emit();
  }

  /** Whether ranges of all lights are drawn, or only of selected ones. */
  get showRanges(): boolean {
    return this.helpers.showRanges;
  }

  set showRanges(show: boolean) {
    this.helpers.showRanges = show;
    this.changed.emit();
  }

  /** Whether colliders and joints of all objects are drawn, or only of selected ones. */
  get showColliders(): boolean {
    return this.hasColliders;
  }

  set showColliders(show: boolean) {
    this.hasColliders = show;
    this.changed.emit();
  }

  /** Whether every frame is drawn, changed or not, to measure frame rates. */
  get continuous(): boolean {
    return this.loop.continuous;
  }

  set continuous(continuous: boolean) {
    this.loop.continuous = continuous;
    this.changed.emit();
  }

  /** Whether frame statistics are shown over the viewport. */
  get showStatistics(): boolean {
    return this.hasStatistics;
  }

  set showStatistics(show: boolean) {
    this.hasStatistics = show;
    this.changed.emit();
  }
}
