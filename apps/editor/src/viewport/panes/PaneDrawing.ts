import type { Camera as CameraComponent, PictureRenderer, Scene } from '@farol/engine';
import { type FarolRenderer, type TechniqueName, type View, views } from '@farol/renderer';
import type { Camera, WebGLRenderer } from 'three';
import type { Gizmo } from '../Gizmo';
import type { Helpers } from '../Helpers';
import type { LateParts } from '../LateParts';
import type { SceneStamps } from '../SceneStamps';
import type { Painter } from '../Painter';
import type { PlainShading } from '../shading/PlainShading';
import { isPlain, techniqueOf, viewOf } from '../shading/Shading';
import type { Panes } from './Panes';
import type { ViewPane } from './ViewPane';

/** The part of the viewport that drawing a view uses. */
export interface PaneSurface {
  readonly document: { readonly scene: Scene };
  readonly webgl: WebGLRenderer;
  readonly farol: FarolRenderer;
  readonly picture: PictureRenderer;
  readonly panes: Panes;
  readonly gizmo: Gizmo;
  readonly helpers: Helpers;
  readonly stamps: SceneStamps;
  readonly parts: Pick<LateParts, 'physics' | 'lightHandles' | 'particles'>;
  readonly painter: Painter | null;
  /** Name of the debug view, see `ViewportSettings`; 'grid' shows all debug views. */
  readonly view: string;
  readonly lookThrough: CameraComponent | null;
  /** Whether the scene is shown as its players see it, with nothing drawn over it. */
  readonly isPlayed: boolean;
  readonly onError: (error: unknown) => void;
  cameraOf(pane: ViewPane): Camera;
  raysOf(pane: ViewPane): Camera;
  invalidate(): void;
}

/** Draws the views: the scene with each view's shading, then lines, icons and handles. */
export class PaneDrawing {
  /** Renderer for shadings without lights; null while it is fetched, undefined before that. */
  private plain: PlainShading | null | undefined;

  constructor(private readonly surface: PaneSurface) {}

  /** Draws all views. @param width - width of the viewport (CSS pixels) @param height - its height */
  drawAll(width: number, height: number): void {
    const { webgl, panes } = this.surface;
    const { list, active } = panes;
    if (list.length > 1) webgl.clear();
    for (let i = 0; i < list.length; i++) if (list[i] !== active) this.draw(list[i], height);
    // the active view is drawn last, since handles are hit-tested where they were last drawn
    this.draw(active, height);
    if (list.length > 1) {
      webgl.setScissorTest(false);
      webgl.setViewport(0, 0, width, height);
    }
  }

  /** Draws a view. @param fullHeight - height of the viewport (CSS pixels) */
  private draw(pane: ViewPane, fullHeight: number): void {
    const { surface } = this;
    const { webgl, panes, gizmo, helpers } = surface;
    const { x, y, width, height } = pane.rectangle;
    if (panes.list.length > 1) {
      // WebGL measures y from the lower edge
      const bottom = fullHeight - y - height;
      webgl.setViewport(x, bottom, width, height);
      webgl.setScissor(x, bottom, width, height);
      webgl.setScissorTest(true);
    }
    const camera = surface.cameraOf(pane);
    const lookThrough = pane === panes.main ? surface.lookThrough : null;
    lookThrough?.setViewport(width, height);
    surface.stamps.draw(surface.document.scene.three, () => this.drawScene(pane, camera, lookThrough));
    gizmo.update(surface.raysOf(pane), surface.isPlayed);
    const view = isPlain(pane.shading) ? null : surface.farol.info.view;
    // `view` is copied, since the renderer overwrites this object when it draws the next view
    pane.shown = view && { ...view, tiles: view.tiles.map((tile) => ({ ...tile })) };
    if (
      !surface.isPlayed &&
      surface.view !== 'grid' &&
      !view?.tiles.length &&
      (surface.painter?.drawsHelpers ?? true)
    ) {
      const { physics, lightHandles, particles } = surface.parts;
      physics.get()?.update(webgl.getPixelRatio());
      lightHandles.get()?.update(webgl.getPixelRatio());
      particles.part?.update();
      helpers.render(webgl, camera, lookThrough, gizmo.isDragging);
    }
  }

  dispose(): void {
    this.plain?.dispose();
  }

  private drawScene(pane: ViewPane, camera: Camera, lookThrough: CameraComponent | null): void {
    const { farol, painter, picture, panes, document } = this.surface;
    const { shading } = pane;
    const { scene } = document;
    if (isPlain(shading) && painter === null && this.plainShading()) {
      this.plain!.render(scene.three, camera, shading);
      return;
    }
    const { technique, view } = farol;
    const shadedBy = techniqueOf(shading);
    const shownAs = viewOf(shading) as View | null;
    try {
      if (shownAs !== null && views.includes(shownAs)) farol.view = shownAs;
      if (shadedBy !== null && Object.hasOwn(farol.techniques, shadedBy)) farol.technique = shadedBy as TechniqueName;
      // side views are for editing: no depth of field, bloom or other effects
      if (painter === null && pane === panes.main) picture.draw(scene, camera, lookThrough);
      else picture.drawBy(painter ?? farol, scene, camera, lookThrough);
    } finally {
      farol.technique = technique;
      farol.view = view;
    }
  }

  /** Fetches the renderer for shadings without lights. @returns whether it has been fetched */
  private plainShading(): boolean {
    const { surface } = this;
    if (this.plain === undefined) {
      this.plain = null;
      import('../shading/PlainShading').then(
        ({ PlainShading }) => {
          this.plain = new PlainShading(surface.webgl);
          surface.invalidate();
        },
        (error) => surface.onError(error),
      );
    }
    return this.plain !== null;
  }
}
