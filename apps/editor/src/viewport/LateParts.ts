import { Camera as CameraComponent, type GameObject, Light } from '@farol/engine';
import type { MicroShaderRegistry } from '@farol/renderer/authoring';
import type { Scene, WebGLRenderer } from 'three';
import type { CameraPreview } from './CameraPreview';
import type { Handle, HandlePoints } from './handles/HandlePoints';
import { LatePart } from './LatePart';
import type { MaterialBall } from './MaterialBall';
import type { ParticlePreview, PreviewHost } from './particles/ParticlePreview';
import type { OverlayHost, PhysicsOverlay } from './physics/PhysicsOverlay';

/** Parts of the viewport that late code uses. */
export interface LateHost extends OverlayHost, PreviewHost {
  readonly webgl: WebGLRenderer;
  /** Helpers drawn over the picture: icons, lines, the gizmo. */
  readonly helpers: { readonly scene: Scene };
  /** The selected camera, whose view is shown as an inset; null for none. */
  readonly previewed: CameraComponent | null;
  shareMicroShaders(registry: MicroShaderRegistry): void;
  onError(error: unknown): void;
}

/** Colour of the lines of a selected light. */
const LIGHT_COLOUR = '#ff9d3c';
/** Radius around the light's position without handles, since its icon and the gizmo's centre are there (CSS pixels). */
const LIGHT_CLEARANCE = 12;

const physicsTypes = ['Collider', 'Joint', 'CharacterController'];

/** The parts of the viewport that most scenes, or the first frame, do not need. */
export class LateParts {
  /** Lines and handles of colliders and joints, fetched once a scene has colliders or joints. */
  readonly physics: LatePart<PhysicsOverlay>;
  /** Handles that resize area lights, fetched once an area light is selected. */
  readonly lightHandles: LatePart<HandlePoints>;
  /** Plays selected particle emitters while the scene is stopped; fetched once a scene has an emitter. */
  readonly particles: LatePart<ParticlePreview>;
  /** The inset with the selected camera's view, fetched once a camera is selected. */
  readonly preview: LatePart<CameraPreview>;

  private ball: MaterialBall | null = null;
  private isDisposed = false;

  constructor(private readonly host: LateHost) {
    const { helpers } = host;
    const failed = (error: unknown): void => host.onError(error);
    const late = <Part extends { dispose(): void }>(isNeeded: () => boolean, load: () => Promise<() => Part>) =>
      new LatePart(isNeeded, load, failed);
    const has = (type: string): boolean => host.document.scene.componentsOf(type).length > 0;
    this.physics = late(
      () => physicsTypes.some(has),
      async () => {
        const { PhysicsOverlay: Overlay } = await import('./physics/PhysicsOverlay');
        return () => {
          const overlay = new Overlay(host);
          helpers.scene.add(overlay.three);
          host.invalidate();
          return overlay;
        };
      },
    );
    this.lightHandles = late(
      () => host.document.selectedObjects.some((object) => object.getComponent(Light)?.isArea),
      async () => {
        const [{ HandlePoints: Points }, { areaLightHandles }] = await Promise.all([
          import('./handles/HandlePoints'),
          import('./lights/areaLightHandles'),
        ]);
        const handlesOf = (object: GameObject): Handle[] => {
          const light = object.getComponent(Light);
          return light?.isActive ? areaLightHandles(light) : [];
        };
        return () => {
          const points = new Points(host, LIGHT_COLOUR, handlesOf, LIGHT_CLEARANCE);
          helpers.scene.add(points.three);
          host.invalidate();
          return points;
        };
      },
    );
    this.particles = late(
      () => has('ParticleEmitter'),
      async () => {
        const { ParticlePreview: Preview } = await import('./particles/ParticlePreview');
        return () => {
          const preview = new Preview(host);
          helpers.scene.add(preview.lines.three);
          return preview;
        };
      },
    );
    this.preview = late(
      () => host.previewed !== null,
      async () => {
        const { CameraPreview: Preview } = await import('./CameraPreview');
        return () => {
          const preview = new Preview(host.webgl, () => host.invalidate());
          host.shareMicroShaders(preview.microshaders);
          host.invalidate();
          return preview;
        };
      },
    );
  }

  /** Draws the inset with the selected camera's view. @param width - width of the canvas (CSS pixels) */
  drawPreview(width: number, height: number): void {
    const { previewed, document } = this.host;
    const preview = this.preview.get();
    if (!previewed || !preview) return;
    const { scene, edited, assetsChanged } = document;
    const key = `${edited.revision} ${scene.time} ${assetsChanged.revision}`;
    preview.render(scene, previewed, width, height, key);
  }

  /**
   * Draws a preview ball of a material: see `MaterialBall.draw`.
   * @throws Error (as a rejection) when the code cannot be fetched; a later call tries again
   */
  async drawBall(...of: Parameters<MaterialBall['draw']>): Promise<void> {
    const { MaterialBall: Ball } = await import('./MaterialBall');
    if (this.isDisposed) return;
    this.ball ??= new Ball(this.host.webgl);
    await this.ball.draw(...of);
  }

  dispose(): void {
    this.isDisposed = true;
    for (const part of [this.physics, this.lightHandles, this.particles, this.preview, this.ball]) part?.dispose();
  }
}
