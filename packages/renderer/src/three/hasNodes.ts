import type { Material } from 'three';

/** True for materials of TSL's nodes, whose shaders three's `setNodesHandler` makes: they have no twins. */
export function hasNodes(material: Material): boolean {
  return (material as Material & { isNodeMaterial?: boolean }).isNodeMaterial === true;
}
