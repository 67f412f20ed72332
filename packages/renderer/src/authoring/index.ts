// Building blocks of techniques, effects and microshaders, see docs/authoring.md.

// passes
export type { Pass } from '../frame/Pass';
export type { HandedResource, Resource, Resources } from '../frame/Resources';
export type { Frame } from '../frame/Frame';
export type { RenderItem } from '../frame/RenderItem';
export { FullscreenPass, type FullscreenPassOptions, type MeshDrawer, type Uniforms } from '../gpu/FullscreenPass';
export { PassTarget, type PassTargetOptions } from '../gpu/PassTarget';
export { WebGLMultipleRenderTargets } from '../three/WebGLMultipleRenderTargets';
export { OutputMaterial, PassMaterial, type PassMaterialOptions } from '../gpu/PassMaterial';
export { targetBytes } from '../gpu/targetBytes';
export { setUnprojectUniforms, unprojectUniforms, type UnprojectUniforms } from '../gpu/unprojectUniforms';

// parts of the built-in techniques
export type { Technique } from '../frame/Technique';
export { forwardTail } from '../techniques/forwardTail';
export { DepthPrepass } from '../passes/forward/DepthPrepass';
export { ForwardPass, type ForwardPassOptions } from '../passes/forward/ForwardPass';
export { GBuffer } from '../gbuffer/GBuffer';
export { gbufferLayout, type GBufferAttachment } from '../gbuffer/gbufferLayout';
export { GBufferPass } from '../passes/gbuffer/GBufferPass';
export { fitsGBuffer, GBufferTarget } from '../passes/gbuffer/GBufferTarget';
export { gbufferUniforms, setGBufferUniforms, type GBufferUniforms } from '../passes/gbuffer/gbufferUniforms';
export { LightVolumesPass } from '../techniques/light-volumes/LightVolumesPass';
export { LightGridPass } from '../techniques/light-lists/LightGridPass';
export type { LightLists } from '../frame/LightLists';
export { LightTilesPass } from '../techniques/light-lists/LightTilesPass';
export { TiledOutputPass } from '../techniques/light-lists/TiledOutputPass';
export type { TileDepthUse } from '../lighting/lists/TileDepthUse';
export type { LightBuffer } from '../frame/LightBuffer';
export type { ThinGBuffer } from '../frame/ThinGBuffer';
export type { AccumulatedLight } from '../frame/AccumulatedLight';
export { DeferredOutputPass } from '../passes/output/DeferredOutputPass';
export { OutputPass } from '../passes/output/OutputPass';

// twins: three's materials with other shaders
export type { TwinKind, TwinRole, TwinShader } from '../materials/TwinKind';
export { litTwin, type LitTwinOptions } from '../materials/litTwin';
export { forwardTwins, type ForwardTwins } from '../materials/forwardTwin';
export { gbufferTwin } from '../passes/gbuffer/gbufferTwins';

// effects
export type { FarolEffect } from '../frame/FarolEffect';
export { Picture } from '../effects/Picture';

// microshaders
export * from '../microshaders';
export { builtinMicroShaders, type BuiltinMicroShader } from './builtinMicroShaders';
export { addMicroShaders } from '../microshaders/addMicroShaders';
export { findClaims, type Claim } from './findClaims';
export { parseMicroShaderXML } from '../microshaders/xml/parseMicroShaderXML';
export { formatMicroShaderXML } from './formatMicroShaderXML';
