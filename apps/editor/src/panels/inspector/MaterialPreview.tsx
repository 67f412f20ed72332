import { t } from '@farol/editing';
import { type Component, ObjectRenderer } from '@farol/engine';
import { type ReactNode, useEffect, useRef, useState } from 'react';
import type { Material } from 'three';
import { useEditor } from '../../ui/EditorContext';
import { useOwnersRevision } from '../../ui/useOwnersRevision';

/** CSS pixels. */
const SIZE = 96;

/** The material as it is drawn now; null where there is none of its own, or several. */
function materialOf(component: Component): Material | null {
  const mesh = component instanceof ObjectRenderer ? component.three : null;
  return mesh && !Array.isArray(mesh.material) ? mesh.material : null;
}

/** A ball of the material, drawn anew whenever a value changes. @param props.components - ObjectRenderers */
export function MaterialPreview({ components }: { components: readonly Component[] }): ReactNode {
  const { viewport, document } = useEditor();
  const revision = useOwnersRevision(components);
  const [assets, setAssets] = useState(0);
  useEffect(() => document.assets.onChange(() => setAssets((count) => count + 1)), [document]);
  const canvas = useRef<HTMLCanvasElement>(null);
  const [component] = components;
  const hasMaterial = materialOf(component) !== null;
  useEffect(() => {
    // once for all changes of a frame, the end of a drag included
    const frame = requestAnimationFrame(() => {
      const material = materialOf(component);
      if (material && canvas.current) void viewport.drawMaterial(material, canvas.current);
    });
    return () => cancelAnimationFrame(frame);
    // oxlint-disable-next-line react/exhaustive-effect-dependencies -- each stands for another material
  }, [viewport, component, revision, assets, hasMaterial]);
  if (!hasMaterial || components.length > 1) return null;
  return (
    <div className="material-preview">
      <canvas ref={canvas} width={SIZE * 2} height={SIZE * 2} role="img" aria-label={t('A ball of this material')} />
    </div>
  );
}
