import type { Scene } from 'three';
import type { OverlayHost, PhysicsOverlay } from './PhysicsOverlay';

const types = ['Collider', 'Joint', 'CharacterController'];

/** Lines and handles for physics; the code is fetched once a scene has any. */
export class LatePhysicsOverlay {
  /** The lines and handles; null until their code is fetched. */
  overlay: PhysicsOverlay | null = null;

  private isAsked = false;
  private isDisposed = false;

  /** @param helpers - the overlay scene */
  constructor(
    private readonly host: OverlayHost,
    private readonly helpers: Scene,
    private readonly failed: (error: unknown) => void,
  ) {}

  /** Called before each frame. */
  update(pixelRatio: number): void {
    this.overlay?.update(pixelRatio);
    if (this.isAsked || !types.some((type) => this.host.document.scene.componentsOf(type).length > 0)) return;
    this.isAsked = true;
    import('./PhysicsOverlay').then(({ PhysicsOverlay: Overlay }) => {
      if (this.isDisposed) return;
      this.overlay = new Overlay(this.host);
      this.helpers.add(this.overlay.three);
      this.host.invalidate();
    }, this.failed);
  }

  dispose(): void {
    this.isDisposed = true;
    this.overlay?.dispose();
  }
}
