import type { Scene } from 'three';
import type { EditorDocument } from '../../model/EditorDocument';
import type { ParticlePreview } from './ParticlePreview';

/** The part of the viewport that the preview uses. */
export interface PreviewHost {
  readonly document: EditorDocument;
  /** Called when the viewport's state changes, to update panels. */
  viewChanged(): void;
}

/** Preview of selected emitters; the code is fetched once a scene has any. */
export class LateParticlePreview {
  /** The preview; null until its code is fetched. */
  preview: ParticlePreview | null = null;

  private isAsked = false;
  private isDisposed = false;

  /** @param helpers - the overlay scene */
  constructor(
    private readonly host: PreviewHost,
    private readonly helpers: Scene,
    private readonly failed: (error: unknown) => void,
  ) {}

  /** Advances time. @returns whether a frame must be drawn */
  advance(seconds: number): boolean {
    if (this.preview) return this.preview.advance(seconds);
    if (this.isAsked || this.host.document.scene.componentsOf('ParticleEmitter').length === 0) return false;
    this.isAsked = true;
    import('./ParticlePreview').then(({ ParticlePreview: Preview }) => {
      if (this.isDisposed) return;
      this.preview = new Preview(this.host);
      this.helpers.add(this.preview.lines.three);
    }, this.failed);
    return false;
  }

  /** Called before each frame. */
  update(): void {
    this.preview?.update();
  }

  dispose(): void {
    this.isDisposed = true;
    this.preview?.dispose();
  }
}
