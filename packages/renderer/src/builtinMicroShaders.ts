import type { MicroShader } from './microshaders/MicroShader';
import { parseMicroShader } from './microshaders/parseMicroShader';
import accumulatedOutput from './output/accumulatedOutput.glsl?raw';
import ambientLight from './lighting/ambientLight.glsl?raw';
import background from './output/background.glsl?raw';
import deferredOutput from './output/deferredOutput.glsl?raw';
import depthMode from './gpu/depthMode.glsl?raw';
import depthOnly from './gpu/depthOnly.glsl?raw';
import farthest from './gpu/farthest.glsl?raw';
import fullscreen from './gpu/fullscreen.glsl?raw';
import gbufferRead from './gbuffer/gbufferRead.glsl?raw';
import gbufferWrite from './gbuffer/gbufferWrite.glsl?raw';
import globalLightsFragment from './lighting/globalLightsFragment.glsl?raw';
import heatMap from './output/heatMap.glsl?raw';
import heatScale from './output/heatScale.glsl?raw';
import incidentLight from './lighting/incidentLight.glsl?raw';
import lightAttenuation from './lighting/lightAttenuation.glsl?raw';
import lightList from './lighting/lists/lightList.glsl?raw';
import lightListClustered from './lighting/lists/lightListClustered.glsl?raw';
import lightMask from './lighting/lightMask.glsl?raw';
import lightLoopAll from './lighting/loops/lightLoopAll.glsl?raw';
import lightLoopNone from './lighting/loops/lightLoopNone.glsl?raw';
import lightLoopOne from './lighting/loops/lightLoopOne.glsl?raw';
import lightLoopTiled from './lighting/loops/lightLoopTiled.glsl?raw';
import lightOneByOne from './lighting/loops/lightOneByOne.glsl?raw';
import lightTable from './lighting/lightTable.glsl?raw';
import lightTiles from './lighting/lists/lightTiles.glsl?raw';
import lightVolumeCone from './lighting/volumes/lightVolumeCone.glsl?raw';
import lightVolumeFragment from './lighting/volumes/lightVolumeFragment.glsl?raw';
import lightVolumeWide from './lighting/volumes/lightVolumeWide.glsl?raw';
import lightVolumeSphere from './lighting/volumes/lightVolumeSphere.glsl?raw';
import octahedralNormal from './gbuffer/octahedralNormal.glsl?raw';
import output from './output/output.glsl?raw';
import shadeSurface from './lighting/shading/shadeSurface.glsl?raw';
import roundToHalf from './gbuffer/roundToHalf.glsl?raw';
import shadePlain from './lighting/shading/shadePlain.glsl?raw';
import shading from './lighting/shading/shading.glsl?raw';
import shadeThree from './lighting/shading/shadeThree.glsl?raw';
import shadeToon from './lighting/shading/shadeToon.glsl?raw';
import storedDistance from './gbuffer/storedDistance.glsl?raw';
import tileDepth from './lighting/lists/tileDepth.glsl?raw';
import tileDepthBlocks from './lighting/lists/tileDepthBlocks.glsl?raw';
import tiledOutput from './output/tiledOutput.glsl?raw';
import tileMask from './lighting/lists/tileMask.glsl?raw';
import tileSummary from './lighting/lists/tileSummary.glsl?raw';
import unproject from './gpu/unproject.glsl?raw';
import viewport from './gpu/viewport.glsl?raw';
import volumeLighting from './lighting/volumes/volumeLighting.glsl?raw';

/** Sources by name. A new microshader is a file and a line here. */
const sources = {
  accumulatedOutput,
  ambientLight,
  background,
  deferredOutput,
  depthMode,
  depthOnly,
  farthest,
  fullscreen,
  gbufferRead,
  gbufferWrite,
  globalLightsFragment,
  heatMap,
  heatScale,
  incidentLight,
  lightAttenuation,
  lightList,
  lightListClustered,
  lightLoopAll,
  lightMask,
  lightLoopNone,
  lightLoopOne,
  lightLoopTiled,
  lightOneByOne,
  lightTable,
  lightTiles,
  lightVolumeCone,
  lightVolumeFragment,
  lightVolumeSphere,
  lightVolumeWide,
  octahedralNormal,
  output,
  roundToHalf,
  shadePlain,
  shadeSurface,
  shading,
  shadeThree,
  shadeToon,
  storedDistance,
  tileDepth,
  tileDepthBlocks,
  tiledOutput,
  tileMask,
  tileSummary,
  unproject,
  viewport,
  volumeLighting,
};

export type BuiltinMicroShader = keyof typeof sources;

export const builtinMicroShaders: readonly MicroShader[] = [
  ...Object.entries(sources).map(([name, text]) => parseMicroShader(name, text)),
];
