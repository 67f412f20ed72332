import { t } from '@farol/editing';
import { Light } from '@farol/engine';
import type { FieldOwner, FieldValue, NumberField } from '@farol/engine/fields';
import {
  type LampKind,
  lampKinds,
  type MeasuredLight,
  shownIntensity,
  shownUnit,
  unitLabels,
  unitsFor,
} from '@farol/engine/photometry';
import type { ReactNode } from 'react';
import type { OwnerFieldProps } from '../../api/FieldEditorProps';
import type { MenuEntry } from '../../api/MenuEntry';
import { setValues } from '../../model/edits';
import { ownersName } from '../../model/ownersName';
import { useEditor, useSignal } from '../../ui/EditorContext';
import { MenuButton } from '../../ui/MenuButton';
import { NumberEditor } from '../NumberEditor';
import { useOwnersRevision } from '../../ui/useOwnersRevision';
import './light.css';

const lampLabels = Light.fields.lamp.optionLabels as Readonly<Record<LampKind, string>>;

/** A light's intensity, in the light's unit (or the field's, when the lights' units differ), and a menu of units. */
export function IntensityEditor(props: OwnerFieldProps<NumberField>): ReactNode {
  const { owners, field, ...rest } = props;
  const { document } = useEditor();
  useOwnersRevision(owners);
  useSignal(document.previewed);
  const lights = owners as unknown as readonly MeasuredLight[];
  const [first, ...others] = lights.map(shownIntensity);
  const isShared = others.every(({ symbol, factor }) => symbol === first.symbol && factor === first.factor);
  const scaled = { ...field, unit: undefined, scale: isShared ? first.factor : 1 };
  return (
    <div className="intensity">
      <NumberEditor {...rest} field={scaled} />
      <UnitMenu lights={lights} owners={owners} symbol={isShared ? first.symbol : (field.unit ?? '')} />
    </div>
  );
}

interface UnitMenuProps {
  readonly lights: readonly MeasuredLight[];
  readonly owners: readonly FieldOwner[];
  readonly symbol: string;
}

/** Menu of the units that all of the lights can have; a choice is one step of history. */
function UnitMenu({ lights, owners, symbol }: UnitMenuProps): ReactNode {
  const editor = useEditor();
  const [light] = lights;
  const [first, ...others] = lights.map(unitsFor);
  const units = first.filter((unit) => others.every((each) => each.includes(unit)));
  if (units.length < 2) return <span className="unit-alone">{t(symbol)}</span>;
  const current = shownUnit(light);
  const choose = (label: string, values: Record<string, FieldValue>): void =>
    editor.commands.run(
      setValues(t('Show intensity of {name} in {unit}', { name: ownersName(owners), unit: label }), owners, values),
    );
  const entries = (): MenuEntry[] =>
    units.map((unit) => {
      const label = t(unit === 'lux' && light.type !== 'directional' ? 'Lux at 1 m (lx)' : unitLabels[unit]);
      if (unit !== 'watt')
        return { label, checked: unit === current, run: () => choose(label, { intensityUnit: unit }) };
      return {
        label,
        entries: lampKinds.map((lamp) => ({
          label: t(lampLabels[lamp]),
          checked: unit === current && lamp === light.lamp,
          run: () => choose(`${label}, ${t(lampLabels[lamp])}`, { intensityUnit: unit, lamp }),
        })),
      };
    });
  const lamp = current === 'watt' && symbol === 'W' ? ` ${t(lampLabels[light.lamp])}` : '';
  return <MenuButton className="button small" label={`${t(symbol)}${lamp}`} entries={entries} />;
}
