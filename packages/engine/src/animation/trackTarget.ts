import { shortText } from '@farol/editing';
import type { Component } from '../core/Component';
import type { GameObject } from '../core/GameObject';
import type { ClipTrack } from '../assets/clips/ClipData';
import { problemWithTrack } from './TrackCurve';

/** First object, in tree order, at a path of names below `root`; '' is `root` itself. */
export function objectAtPath(root: GameObject, path: string): GameObject | null {
  if (path === '') return root;
  for (const child of root.children) {
    if (child.name === '') continue;
    if (child.name === path) return child;
    // object names may contain slashes, so the path is not split
    const found = path.startsWith(`${child.name}/`) ? objectAtPath(child, path.slice(child.name.length + 1)) : null;
    if (found) return found;
  }
  return null;
}

/**
 * Path that finds an object from `root`; null when the object is not below `root`, or an earlier object has the same
 * names.
 */
export function pathBelow(root: GameObject, gameObject: GameObject): string | null {
  const names: string[] = [];
  let each: GameObject | null = gameObject;
  for (; each && each !== root; each = each.parent) names.unshift(each.name);
  const path = names.join('/');
  return each && objectAtPath(root, path) === gameObject ? path : null;
}

/** Component that a track animates, or a message that names the missing part and its remedy. */
export type TrackTarget =
  | { readonly component: Component; readonly problem: null }
  | { readonly component: null; readonly problem: string };

/** Finds the component that a track of a clip animates, from the object that plays the clip. */
export function trackTarget(root: GameObject, track: ClipTrack): TrackTarget {
  const none = (problem: string): TrackTarget => ({ component: null, problem });
  const object = objectAtPath(root, track.path);
  const whole = [shortText(root.name), ...(track.path === '' ? [] : [shortText(track.path, 80)])].join('/');
  if (!object) return none(`the object '${whole}' is gone: give an object this name, or take its tracks out.`);
  const component = object.getComponent(track.component);
  const type = shortText(track.component);
  if (!component) return none(`'${whole}' has no ${type}: add one, or take its tracks out.`);
  const field = Object.hasOwn(component.fields, track.field) ? component.fields[track.field] : null;
  if (!field) return none(`${type} of '${whole}' has no field '${shortText(track.field)}': take its track out.`);
  const problem = problemWithTrack(track, field);
  return problem ? none(`${type}.${track.field} of '${whole}', ${problem}.`) : { component, problem: null };
}
