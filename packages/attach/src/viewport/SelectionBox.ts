import { BoxHelper, type LineBasicMaterial, type Object3D, type Scene } from 'three';
import type { Session } from '../model/Session';

/** Objects, with those below them, up to which boxes are measured anew each frame; beyond that there is none. */
const MEASURED = 200;

/** Boxes of lines round the selected objects. */
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

  /** Measures the objects where they are now. */
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
      if (selected === scene || count > MEASURED) return [];
      selected.traverse((object) => {
        count++;
        isShown ||= 'geometry' in object;
      });
      return isShown && count <= MEASURED ? [makeBox(selected)] : [];
    });
    if (this.boxes.length > 0) this.scene.add(...this.boxes);
  }
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
