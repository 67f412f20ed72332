import { t } from '@farol/editing';
import { Popover } from '@base-ui/react/popover';
import { type ReactNode, useRef } from 'react';
import { Icon } from '../../ui/Icon';
import { NumberInput } from '../../ui/NumberInput';
import { SelectBox } from '../../ui/SelectBox';
import { Toggle } from '../../ui/Toggle';
import type { Preferences } from '../../api/preferences';
import { useEditor } from '../../ui/EditorContext';
import { usePreferences } from '../../ui/usePreferences';

const steps = () =>
  [
    { name: 'translate', label: t('Distance'), unit: 'm', min: 0.001, max: 1000, step: 0.1 },
    { name: 'rotate', label: t('Angle'), unit: '°', min: 0.1, max: 180, step: 1 },
    { name: 'scale', label: t('Scale'), unit: '', min: 0.001, max: 10, step: 0.05 },
  ] as const;

/** Button for the snapping increments of the gizmo, which are remembered. */
export function SnapSteps(): ReactNode {
  const { preferences } = useEditor();
  const chosen = usePreferences(({ snapSteps }) => snapSteps);
  const snapTo = usePreferences((all) => all.snapTo);
  const alignsToSurface = usePreferences((all) => all.alignsToSurface);
  const pivot = usePreferences((all) => all.pivot);
  const set = (name: keyof Preferences['snapSteps'], value: number): void => {
    preferences.setState(({ snapSteps }) => ({ snapSteps: { ...snapSteps, [name]: value } }));
  };
  const kept = useRef(chosen);
  return (
    <Popover.Root>
      <Popover.Trigger className="button snap-steps" aria-label={t('Snap steps')} title={t('Snap steps')}>
        <Icon name="down" size={12} />
      </Popover.Trigger>
      <Popover.Portal>
        <Popover.Positioner className="positioner" sideOffset={3} align="start">
          <Popover.Popup className="popup snap-popup" aria-label={t('Snap steps')}>
            <div className="snap-row">
              <span aria-hidden="true">{t('Snap to')}</span>
              <SelectBox
                value={snapTo}
                label={t('Snap to')}
                options={[
                  { value: 'grid', label: t('Steps') },
                  { value: 'surface', label: t('Surfaces') },
                  { value: 'vertex', label: t('Vertices') },
                ]}
                onChange={(target) => preferences.setState({ snapTo: target })}
              />
            </div>
            {snapTo === 'surface' && (
              <div className="snap-row">
                <span aria-hidden="true">{t('Turn along it')}</span>
                <Toggle
                  value={alignsToSurface}
                  label={t('Turn along the surface')}
                  onChange={(aligns) => preferences.setState({ alignsToSurface: aligns })}
                />
              </div>
            )}
            <div className="snap-row">
              <span aria-hidden="true">{t('Pivot')}</span>
              <SelectBox
                value={pivot}
                label={t('Pivot')}
                options={[
                  { value: 'centre', label: t('Centre'), help: t('Centre of all that is selected') },
                  { value: 'each', label: t('Each'), help: t('Each object turns and grows in its place') },
                  { value: 'active', label: t('Last'), help: t('The object selected last') },
                ]}
                onChange={(chosenPivot) => preferences.setState({ pivot: chosenPivot })}
              />
            </div>
            {steps().map(({ name, label, ...rest }) => (
              <div key={name} className="snap-row">
                <span aria-hidden="true">{label}</span>
                <NumberInput
                  {...rest}
                  value={chosen[name]}
                  label={t('{label} of a snap step', { label })}
                  handle={<span className="grip" />}
                  onPreview={(value) => set(name, value)}
                  onCommit={() => void (kept.current = preferences.getState().snapSteps)}
                  onDiscard={() => preferences.setState({ snapSteps: kept.current })}
                />
              </div>
            ))}
          </Popover.Popup>
        </Popover.Positioner>
      </Popover.Portal>
    </Popover.Root>
  );
}
