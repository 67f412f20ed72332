import { BufferGeometry, Mesh } from 'three';

/** One triangle that covers the viewport, its corners made from gl_VertexID, so that nothing is uploaded. */
export class FullscreenMesh extends Mesh {
  constructor() {
    const geometry = new BufferGeometry();
    geometry.setDrawRange(0, 3);
    super(geometry);
    this.frustumCulled = false;
  }
}
