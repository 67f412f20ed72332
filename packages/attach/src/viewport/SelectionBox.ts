import { BoxHelper, type LineBasicMaterial, type Object3D, type Scene } from 'three';
import type { Session } from '../model/Session';

/** Objects below the selected one up to which its box is measured anew each frame. */
const MEASURED = 200;

/** A box of lines round the selected object. */
export class SelectionBox {
  private readonly box = new BoxHelper(undefined as unknown as Object3D, 0xffa044);
  private readonly end: () => void;

  constructor(
    private readonly session: Session,
    scene: Scene,
  ) {
    const material = this.box.material as LineBasicMaterial;
    material.depthTest = false;
    material.transparent = true;
    material.toneMapped = false;
    this.box.frustumCulled = false;
    this.end = session.selectionChanged.listen(() => this.follow());
    this.follow();
    scene.add(this.box);
  }

  /** Measures the object where it is now. */
  update(): void {
    if (this.box.visible) this.box.update();
  }

  dispose(): void {
    this.end();
    this.box.dispose();
  }

  private follow(): void {
    const { selected, scene } = this.session;
    let count = 0;
    let shown = false;
    selected?.traverse((object) => {
      count++;
      shown ||= 'geometry' in object;
    });
    this.box.visible = shown && selected !== scene && count <= MEASURED;
    if (this.box.visible) this.box.setFromObject(selected!);
  }
}
