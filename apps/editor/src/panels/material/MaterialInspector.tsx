import { labelOfField, t } from '@farol/editing';
import type { MaterialAsset } from '@farol/engine';
import { isFieldVisible } from '@farol/engine/fields';
import { Fragment, type ReactNode, useMemo, useState } from 'react';
import { FieldList } from '../inspector/FieldList';
import { Section } from '../inspector/Section';
import { useIsFiltering } from '../../ui/FieldFilter';
import { Icon } from '../../ui/Icon';
import { TurningBall } from '../../ui/TurningBall';
import { useOwnersRevision } from '../../ui/useOwnersRevision';
import { EditSurface } from './EditSurface';
import { isMapField, type MaterialSection, materialSections, placementFields } from './materialSections';

/** Inspector of a library material: a preview sphere that can be rotated, and its fields in sections. */
export function MaterialInspector({ material }: { material: MaterialAsset }): ReactNode {
  const owners = useMemo(() => [material], [material]);
  const revision = useOwnersRevision(owners);
  return (
    <>
      <TurningBall materialOf={() => material.three} revision={revision} label={t('A ball of this material')} />
      {materialSections.map((section) => (
        <SectionOfMaterial key={section.id} material={material} owners={owners} section={section} />
      ))}
    </>
  );
}

interface SectionOfMaterialProps {
  readonly material: MaterialAsset;
  readonly owners: readonly MaterialAsset[];
  readonly section: MaterialSection;
}

function SectionOfMaterial({ material, owners, section }: SectionOfMaterialProps): ReactNode {
  const { id, title, help, fields, isFoldedAtFirst, forward } = section;
  const uniforms = fields.includes('surface')
    ? Object.keys(material.fields).filter((name) => material.fields[name].viewOf)
    : [];
  const shown = [...fields, ...uniforms].filter((name) =>
    isFieldVisible(material.fields, name, (other) => material.get(other)),
  );
  if (shown.length === 0) return null;
  const isForward = forward !== undefined && shown.includes(forward) && Boolean(material.get(forward));
  const limit = t('Drawn forward: a G-buffer cannot hold it. The picture is right, and costs more with many lights.');
  return (
    <Section
      id={`Material ${id}`}
      title={title()}
      help={help()}
      icon="contrast"
      isFoldedAtFirst={isFoldedAtFirst}
      controls={
        isForward && (
          <span className="material-limit" title={limit} data-help={limit}>
            {t('Drawn forward')}
          </span>
        )
      }
    >
      {shown.map((name) => (
        <Fragment key={name}>
          <FieldList owners={owners} names={[name]} />
          {name === 'surface' && material.get(name) !== null && <EditSurface name={material.get(name) as string} />}
          {isMapField(name) && material.get(name) !== null && <Placement owners={owners} map={name} />}
        </Fragment>
      ))}
    </Section>
  );
}

/** UV placement of a map, folded by default. */
function Placement({ owners, map }: { owners: readonly MaterialAsset[]; map: string }): ReactNode {
  const [isChosen, setOpen] = useState(false);
  const isFiltering = useIsFiltering();
  const isOpen = isChosen || isFiltering;
  const names = useMemo(() => placementFields(map), [map]);
  const [{ fields }] = owners;
  return (
    <div className="placement">
      {!isFiltering && (
        <button
          type="button"
          className="placement-title"
          aria-expanded={isOpen}
          aria-label={t('Placement of {map}', { map: labelOfField(map, fields[map]) })}
          onClick={() => setOpen(!isOpen)}
        >
          <span className="fold" data-open={isOpen}>
            <Icon name="chevron" size={10} />
          </span>
          {t('Placement')}
        </button>
      )}
      {isOpen && (
        <div className="placement-fields">
          <FieldList owners={owners} names={names} />
        </div>
      )}
    </div>
  );
}
