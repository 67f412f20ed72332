import { asset, boolean, number, string } from '@farol/editing/fields';
import { storeLightOptions } from '@farol/renderer/light-options';
import { type Bone, type Light as ThreeLight, type Material, type Mesh, Object3D, type SkinnedMesh } from 'three';
import { LoopedClip } from '../animation/LoopedClip';
import type { Model } from '../assets/Model';
import { type ModelSubtree, subtreeOf } from '../assets/modelNodes';
import type { Scene } from '../core/Scene';
import { MorphTargets, morphTargetFields } from './MorphTargets';
import { fitBounds, objectSurfaceFields, ObjectSurface } from './ObjectSurface';
import { component } from '../core/Component';
import type { FieldViews } from '../fields/FieldOwner';

type Light = ThreeLight & { target?: Object3D };

const isMesh = (object: Object3D): object is Mesh => 'isMesh' in object;

/**
 * Copies of a model's nodes by their originals: of all nodes, or of those that a subtree draws, whose root gets the
 * identity transform, since the GameObject holds its pose. Copied meshes and lights refer to copied bones and targets.
 */
function copiesOf(model: Model, subtree: ModelSubtree | null): Map<Object3D, Object3D> {
  const copies = new Map<Object3D, Object3D>();
  const copy = (from: Object3D, isDrawn: boolean): Object3D => {
    const draws = isDrawn || subtree!.tops.has(from);
    // nodes between the root and its drawn parts draw nothing themselves
    const to = draws ? copyAlone(from) : new Object3D().copy(from, false);
    copies.set(from, to);
    for (const child of draws ? from.children : subtree!.between.get(from)!) to.add(copy(child, draws));
    return to;
  };
  const top = copy(subtree?.root ?? model.scene, !subtree);
  if (subtree) {
    top.position.set(0, 0, 0);
    top.quaternion.identity();
    top.scale.set(1, 1, 1);
  }
  for (const [from, to] of copies) {
    if ('isSkinnedMesh' in from) bindCopy(from as SkinnedMesh, to as SkinnedMesh, copies);
    if ('isLight' in from) aimCopy(model, from as Light, to as Light, copies);
  }
  return copies;
}

/** Copy of a node without its children; `clone` of some classes copies children regardless of its argument. */
const copyAlone = (node: Object3D): Object3D =>
  (new (node.constructor as new () => Object3D)() as Object3D).copy(node, false);

/** Binds a copied mesh to a skeleton of the copied bones. */
function bindCopy(from: SkinnedMesh, to: SkinnedMesh, copies: ReadonlyMap<Object3D, Object3D>): void {
  const skeleton = from.skeleton.clone();
  skeleton.bones = from.skeleton.bones.map((bone) => copies.get(bone) as Bone);
  to.bind(skeleton, to.bindMatrix.copy(from.bindMatrix));
}

function aimCopy(model: Model, from: Light, to: Light, copies: ReadonlyMap<Object3D, Object3D>): void {
  const target = from.target && copies.get(from.target);
  if (target) to.target = target;
  const profile = model.profileOf(from);
  if (profile) storeLightOptions(to, { profile: profile.texture });
}

/**
 * Draws a whole model, such as a glTF, with its materials, skeletons and morph targets; an `Animation` plays its clips.
 * The weight of a morph target is a field, such as 'morph.Smile', which clip assets can animate too. All renderers of a
 * model share its geometries, materials and textures.
 */
export class ModelRenderer extends component({
  model: asset('model', null, { help: 'The model that is drawn.' }),
  parts: string('', {
    help: 'Draws only these nodes of the model, with all below them: paths such as Arm/Hand, with semicolons between them. The whole model when empty.',
  }),
  castShadow: boolean(true, { help: 'Whether it casts shadows.', label: 'Cast shadow' }),
  receiveShadow: boolean(true, { help: 'Whether shadows fall on it.', label: 'Receive shadow' }),
  ...objectSurfaceFields,
  surfaceMaterial: string('', {
    choices: 'materials',
    help: 'The material of the model whose parts get the surface; all of them when none is chosen.',
    label: 'On material',
  }),
  ...morphTargetFields,
  animation: string('', {
    choices: 'animations',
    help: 'The clip that plays while the scene plays.',
    label: 'Clip',
    deprecated: true,
  }),
  animationSpeed: number(1, {
    step: 0.1,
    help: 'Factor of the speed; below 0 it runs backwards.',
    label: 'Speed',
    deprecated: true,
  }),
}) {
  static override readonly typeName: string = 'ModelRenderer';
  static override readonly icon: string = 'mesh';
  static override readonly unique: boolean = true;
  static override readonly help: string = 'A whole model, such as a glTF; an Animation plays its clips.';

  private readonly worn = new ObjectSurface(
    this,
    ModelRenderer.fields,
    () => this.applyFlags(),
    () => this.fitBounds(),
    [() => this.morphs?.fields ?? null],
  );
  private morphs: MorphTargets | null = null;
  private inUse: Model | null = null;
  private copies: ReadonlyMap<Object3D, Object3D> = new Map();
  private subtree: ModelSubtree | null = null;
  private copy: Object3D | null = null;
  private looped: LoopedClip | null = null;

  /** Root of the drawn tree, below the GameObject's object3D; null outside a scene and until the asset is loaded. */
  get three(): Object3D | null {
    return this.copy;
  }

  /** The drawn model; null until loaded. */
  get drawnModel(): Model | null {
    return this.inUse;
  }

  /** Node of `three` that is the copy of a node of the model. */
  copyOf(node: Object3D): Object3D | null {
    return this.copies.get(node) ?? null;
  }

  /** Node of the model that the object corresponds to when only parts are drawn; null when all of the model is. */
  get partsRoot(): Object3D | null {
    return this.subtree?.root ?? null;
  }

  /** Names of the animations that the model has. */
  get animations(): string[] {
    return this.inUse?.animations.map(({ name }) => name) ?? [];
  }

  /** Names of the materials that the model has. */
  get materials(): string[] {
    const names = new Set<string>();
    this.inUse?.scene.traverse((object) => {
      if (isMesh(object)) for (const { name } of [object.material].flat()) if (name) names.add(name);
    });
    return [...names];
  }

  /** @internal */
  override get fieldViews(): FieldViews | undefined {
    return this.worn?.views;
  }

  override onEnterScene(): void {
    this.refresh();
  }

  override onLeaveScene(scene: Scene): void {
    this.clear(scene);
  }

  override onFieldChanged(name: string): void {
    if (!this.scene || this.worn.fieldChanged(name) || this.morphs?.fieldChanged(name)) return;
    if (name === 'model' || name === 'parts') this.refresh();
    else if (name === 'animation') this.startAnimation();
    else this.applyFlags();
  }

  override endSimulation(): void {
    super.endSimulation();
    if (this.scene) this.worn.simulationEnded();
  }

  override onActiveChanged(): void {
    this.applyFlags();
  }

  override update(_deltaSeconds: number, time: number): void {
    this.looped?.show(time * this.animationSpeed);
  }

  private refresh(): void {
    const { scene, model: name } = this;
    if (!scene) return;
    this.clear(scene);
    if (name === null) return;
    if (!scene.assets.isReady('model', name)) {
      scene.assets.whenReady('model', name, () => {
        if (this.scene === scene && this.model === name) this.refresh();
      });
      return;
    }
    this.inUse = scene.assets.model(name);
    scene.assets.uses.acquire(this.inUse);
    const { scene: source } = this.inUse;
    this.subtree = subtreeOf(source, this.parts);
    this.copies = copiesOf(this.inUse, this.subtree);
    this.copy = this.copies.get(this.subtree?.root ?? source)!;
    this.gameObject.object3D.add(this.copy);
    this.morphs = new MorphTargets(this, this.inUse, this.parts, this.copies);
    this.morphs.show();
    this.applyFlags();
    this.startAnimation();
  }

  private startAnimation(): void {
    this.looped?.end();
    this.looped = null;
    const clip = this.inUse?.clips.find(({ name }) => name === this.animation);
    if (!this.copy || !clip) return;
    this.looped = new LoopedClip(clip, this.gameObject, this);
    this.looped.show((this.scene?.time ?? 0) * this.animationSpeed);
  }

  private applyFlags(): void {
    const { copy } = this;
    if (!copy) return;
    copy.visible = this.enabled;
    copy.traverse((object) => {
      if (!('isMesh' in object)) return;
      object.castShadow = this.castShadow;
      object.receiveShadow = this.receiveShadow;
    });
    this.dress();
    this.scene?.baked.dress(this.id, copy);
    this.fitBounds();
  }

  /** Applies the model's materials to the parts, with the surface on top. */
  private dress(): void {
    if (!this.scene) return;
    const { surfaceMaterial } = this;
    this.worn.dress(this.scene, (wear) => {
      const drawn = (source: Material): Material =>
        surfaceMaterial === '' || source.name === surfaceMaterial ? wear(source) : source;
      for (const [from, to] of this.copies)
        if (isMesh(from))
          (to as Mesh).material = Array.isArray(from.material) ? from.material.map(drawn) : drawn(from.material);
    });
  }

  private fitBounds(): void {
    for (const [from, to] of this.copies) if (isMesh(from)) fitBounds(to as Mesh, from.frustumCulled);
  }

  private clear(scene: Scene): void {
    this.looped = null;
    this.morphs = null;
    this.worn.end(scene);
    if (this.copy) scene.baked.undress(this.copy);
    this.copy?.removeFromParent();
    this.copy = null;
    this.copies = new Map();
    this.subtree = null;
    if (this.inUse) scene.assets.uses.release(this.inUse);
    this.inUse = null;
  }
}
