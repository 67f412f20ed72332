import { LessEqualDepth } from 'three';
import type { Frame } from '../frame/Frame';
import { FullscreenMesh } from '../gpu/FullscreenMesh';
import { PassMaterial } from '../gpu/PassMaterial';

/** Writes the colour that three would have cleared the target to behind all that is drawn: only where depth is still 1. */
export class BackgroundDraw {
  private readonly triangle = new FullscreenMesh();
  private material: PassMaterial | null = null;

  draw(frame: Frame): void {
    this.material ??= new PassMaterial(frame.microshaders, {
      name: 'Farol background',
      vertex: ['farthest'],
      fragment: ['background'],
      uniforms: { ...frame.uniforms },
      depthTest: true,
      // of 1 where it is 1: three's usual state stays as it is
      depthWrite: true,
      depthFunc: LessEqualDepth,
    });
    frame.drawMesh(this.triangle, this.material);
  }

  dispose(): void {
    this.material?.dispose();
    this.material = null;
  }
}
