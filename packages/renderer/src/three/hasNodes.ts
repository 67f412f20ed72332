import type { Material } from 'three';

/** True for node materials (TSL), whose shaders are made by three's `setNodesHandler`: they have no twins. */
export function hasNodes(material: Material): boolean {
  return (material as Material & { isNodeMaterial?: boolean }).isNodeMaterial === true;
}
