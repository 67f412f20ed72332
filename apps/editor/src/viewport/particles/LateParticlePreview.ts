import type { Scene } from 'three';
import type { EditorDocument } from '../../model/EditorDocument';
import type { ParticlePreview } from './ParticlePreview';

/** What the preview needs of the viewport. */
export interface PreviewHost {
  readonly document: EditorDocument;
  /** Tells those who show what the viewport does. */
  viewChanged(): void;
}

/** The preview of selected emitters, fetched once a scene has any. */
export class LateParticlePreview {
  /** Null until it was fetched. */
  preview: ParticlePreview | null = null;

  private isAsked = false;
  private isDisposed = false;

  /** @param helpers - what is drawn over the picture */
  constructor(
    private readonly host: PreviewHost,
    private readonly helpers: Scene,
    private readonly failed: (error: unknown) => void,
  ) {}

  /** Lets time pass. @returns whether a frame is to be drawn */
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

  /** Called before each picture. */
  update(): void {
    this.preview?.update();
  }

  dispose(): void {
    this.isDisposed = true;
    this.preview?.dispose();
  }
}
