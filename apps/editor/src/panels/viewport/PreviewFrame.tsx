import { t } from '@farol/editing';
import { type ReactNode, useSyncExternalStore } from 'react';
import { useEditor } from '../../ui/EditorContext';
import { IconButton } from '../../ui/IconButton';
import { previewPlace } from '../../viewport/previewPlace';

/** Frame around the inset with the selected camera's view, which the viewport draws. */
export function PreviewFrame(): ReactNode {
  const { viewport } = useEditor();
  const camera = useSyncExternalStore(viewport.drawn.subscribe, () => viewport.previewed);
  const place = useSyncExternalStore(viewport.drawn.subscribe, () => {
    const { width, height } = viewport.size;
    return Object.values(previewPlace(width, height)).join();
  });
  if (!camera) return null;
  const [width, height, margin] = place.split(',').map(Number);
  return (
    <div className="preview-frame" style={{ width, height, right: margin, bottom: margin }}>
      <span>{camera.gameObject.name}</span>
      <IconButton
        icon="maximise"
        label={t('Look through {name}', { name: camera.gameObject.name })}
        title={t('Look through this camera')}
        onClick={() => {
          viewport.lookThrough = camera;
        }}
      />
    </div>
  );
}
