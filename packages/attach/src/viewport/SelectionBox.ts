import { BoxHelper, type LineBasicMaterial, type Mesh, type Object3D, type Scene, type SkinnedMesh } from 'three';
import type { Session } from '../model/Session';
import { isReadable } from './isReadable';

/**
 * Number of objects, descendants included, up to which boxes are computed each frame; with more, no boxes are shown.
 */
const MEASURED = 200;

/** Wireframe boxes around the selected objects. */
export class SelectionBox {
  private boxes: BoxHelper[] = [];
  private readonly end: () => void;

  constructor(
    private readonly session: Session,
    private readonly scene: Scene,
  ) {
    this.end = session.selection.changed.subscribe(() => this.follow());
    this.follow();
  }

  /** Computes the boxes from the objects' present poses. */
  update(): void {
    for (const box of this.boxes) box.update();
  }

  dispose(): void {
    this.end();
    this.clear();
  }

  private clear(): void {
    for (const box of this.boxes.splice(0)) {
      box.removeFromParent();
      box.dispose();
    }
  }

  private follow(): void {
    this.clear();
    const {
      selection: { items: selection },
      scene,
    } = this.session;
    let count = 0;
    this.boxes = selection.flatMap((selected) => {
      let isShown = false;
      let isMeasured = true;
      if (selected === scene || count > MEASURED) return [];
      selected.traverse((object) => {
        count++;
        if (!('geometry' in object)) return;
        isShown = true;
        isMeasured &&= isMeasurable(object as Mesh);
      });
      return isShown && isMeasured && count <= MEASURED ? [makeBox(selected)] : [];
    });
    if (this.boxes.length > 0) this.scene.add(...this.boxes);
  }
}

/** Whether three can compute the bounding box of an object. */
function isMeasurable(object: Mesh): boolean {
  const { boundingBox = object.geometry.boundingBox } = object as Mesh & Partial<Pick<SkinnedMesh, 'boundingBox'>>;
  return boundingBox !== null || isReadable(object.geometry);
}

function makeBox(object: Object3D): BoxHelper {
  const box = new BoxHelper(object, 0xffa044);
  const material = box.material as LineBasicMaterial;
  material.depthTest = false;
  material.transparent = true;
  material.toneMapped = false;
  box.frustumCulled = false;
  return box;
}
