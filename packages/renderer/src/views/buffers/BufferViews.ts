import type { Frame } from '../../frame/Frame';
import { Lazy } from '../../frame/Lazy';
import type { ViewInfo } from '../../frame/ViewInfo';
import type { View } from '../../frame/views';
import type { SurfaceViewPass } from '../SurfaceViewPass';
import { AtlasView } from './AtlasView';
import type { BufferView, ShownView } from './BufferView';
import { FogView } from './FogView';
import { FroxelView } from './FroxelView';
import { LightBufferView } from './LightBufferView';
import { MotionView } from './MotionView';
import { PixelView } from './PixelView';
import { problems } from './problems';

const NO_TILES: ShownView['tiles'] = [];

/** The views drawn over the finished picture, each created when first shown. */
export class BufferViews {
  private readonly made = new Map<View, BufferView>();
  private readonly info: ShownView = { view: 'final', problem: null, fullMotion: 0, tiles: NO_TILES };
  private readonly reported = new Set<string>();

  constructor(private readonly surfaces: SurfaceViewPass) {}

  /** Draws a view over the finished picture, or nothing if the frame lacks its buffer, with one warning. */
  show(frame: Frame, name: View): ViewInfo {
    let view = this.made.get(name);
    if (view === undefined) this.made.set(name, (view = this.make(name)));
    const { info, reported } = this;
    info.view = name;
    info.fullMotion = 0;
    info.tiles = NO_TILES;
    info.problem = view.show(frame, info);
    // else a frame budget would show the finer picture instead of the view
    if (info.problem === null) frame.finer = null;
    // no warning while code is loading: another technique, or no effect, may draw until then
    else if (!reported.has(info.problem) && Lazy.lacking!.size === 0) {
      reported.add(info.problem);
      console.warn(`Farol: the view '${name}' shows the final picture. ${info.problem}`);
    }
    return info;
  }

  dispose(): void {
    for (const view of this.made.values()) view.dispose();
  }

  private make(name: View): BufferView {
    switch (name) {
      case 'motion':
        return new MotionView();
      case 'reactive-mask':
        return new PixelView(({ resources }) => {
          const motion = resources.find('motion');
          return motion === undefined ? problems.reactive : (motion.reactive ?? problems.notReactive);
        });
      case 'light-buffer':
        return new LightBufferView();
      case 'shadow-atlas':
        return new AtlasView(false);
      case 'image-atlas':
        return new AtlasView(true);
      case 'fog-light':
        return new FogView(this.surfaces, 0);
      case 'fog-transmittance':
        return new FogView(this.surfaces, 1);
      case 'froxels':
        return new FroxelView();
      default:
        return new PixelView((frame) => frame.resources.find('occlusion')?.openSky(frame) ?? problems.occlusion);
    }
  }
}
