/** Builders of meshes in code, and the names of the textures that are made in code. */
export { MeshBuilder, type Profile, type Surface } from './geometry/MeshBuilder';
export { textureName } from './textures/builtinTextures';
