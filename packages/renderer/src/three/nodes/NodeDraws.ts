import { type Camera, type Material, Object3D, type Scene, type WebGLRenderer } from 'three';
import { isPlainOpaque } from '../drawOrder';
import { hasNodes } from '../hasNodes';
import type { RenderListItem } from '../RenderListItem';
import { type RenderList, type RenderLists, renderListsOf } from '../RenderList';
import { standInOf } from '../standInOf';

/** Properties of a frame's draw that are read here. */
interface NodeItem extends RenderListItem {
  /** Shading of the item: 'nodes' for items with node materials. */
  readonly shading: string;
  /** Route of the item: 'plain' for items that may be drawn in any order. */
  readonly route: string;
  drawn: boolean;
}

/** Parts of a `Frame` that draws of node materials use. */
interface DrawnFrame {
  readonly webgl: WebGLRenderer;
  readonly scene: Scene;
  readonly camera: Camera;
  readonly queue: { readonly opaque: readonly NodeItem[] };
}

/** Stand-in for a host's scene, and its render list, which three fills. */
interface NodeView {
  readonly view: Object3D;
  readonly list: RenderList;
  /** three's render lists, among them `list`; replaced when a lost context is restored. */
  readonly lists: RenderLists;
}

const NOTHING = () => undefined;

/**
 * Draws items with node materials (TSL) by three's own `render` inside the frame, with three's lights and shadow maps, since
 * only that passes objects and lights to the nodes handler. Other objects are kept out of three's lists.
 */
export class NodeDraws {
  private readonly views = new WeakMap<Object3D, NodeView>();
  private current!: NodeView;
  private getList!: RenderLists['get'];
  /** Item to draw; null for all opaque items of route 'plain'. */
  private item: NodeItem | null = null;
  /** Whether three has drawn its shadow maps in this frame. */
  private hasMaps = false;

  begin(): void {
    this.hasMaps = false;
  }

  /** Draws an item into the bound target; the first opaque one of route 'plain' draws all of these, and marks them drawn. */
  draw({ webgl, scene, camera, queue }: DrawnFrame, item: NodeItem): void {
    this.current = this.viewOf(webgl, scene);
    const plain = item.route === 'plain';
    this.item = plain ? null : item;
    this.render(webgl, camera);
    if (!plain) return;
    for (const other of queue.opaque) if (other.shading === 'nodes' && other.route === 'plain') other.drawn = true;
  }

  private render(webgl: WebGLRenderer, camera: Camera): void {
    const { info, shadowMap, autoClear } = webgl;
    const { autoReset } = info;
    const { render } = shadowMap;
    const { view, lists } = this.current;
    this.getList = lists.get;
    try {
      lists.get = this.giveList;
      webgl.autoClear = info.autoReset = false;
      if (this.hasMaps) shadowMap.render = NOTHING;
      webgl.render(view, camera);
      this.hasMaps = true;
    } finally {
      lists.get = this.getList;
      webgl.autoClear = autoClear;
      info.autoReset = autoReset;
      shadowMap.render = render;
    }
  }

  private readonly giveList: RenderLists['get'] = (scene, depth) =>
    scene === this.current.view ? this.current.list : this.getList(scene, depth);

  private viewOf(webgl: WebGLRenderer, source: Scene): NodeView {
    const lists = renderListsOf(webgl);
    let known = this.views.get(source);
    if (known?.lists === lists) return known;
    const isScene = source.isScene === true;
    const view = isScene ? standInOf(source, Object3D.prototype) : new Object3D();
    const own = {
      matrixWorldAutoUpdate: false,
      onBeforeRender: NOTHING,
      onAfterRender: NOTHING,
      ...(isScene ? { background: null } : { children: [source] }),
    };
    for (const [name, value] of Object.entries(own)) Object.defineProperty(view, name, { value, writable: true });
    const list = lists.get(view, 0);
    const { push } = list;
    list.push = (object, geometry, material, groupOrder, z, group, camera) => {
      const { overrideMaterial = null } = source as Partial<Scene>;
      const drawn = overrideMaterial !== null && material.allowOverride ? overrideMaterial : material;
      const { item } = this;
      const isWanted =
        item === null
          ? hasNodes(drawn) && isPlainOpaque(drawn) && !transmits(material)
          : object === item.object && group === item.group && drawn === item.material;
      if (isWanted) push(object, geometry, material, groupOrder, z, group, camera);
    };
    this.views.set(source, (known = { view, list, lists }));
    return known;
  }
}

function transmits(material: Material): boolean {
  return ((material as Material & { transmission?: number }).transmission ?? 0) > 0;
}
