import type { Texts } from './translate';

/** Spanish texts of this package, by their English ones. */
export const es: Texts = {
  'Ambient occlusion is not in this frame: switch it on, with a technique that has depth before it lights, such as Deferred shading, Light pre-pass or Forward+.':
    'En este fotograma no hay oclusión ambiental: se activa, con una técnica que conozca la profundidad antes de sombrear, como Sombreado diferido, Light pre-pass o Forward+.',
  'Motion is not in this frame: switch on the anti-aliasing TAA.':
    'En este fotograma no hay movimiento: hay que activar el antialiasing TAA.',
  'The reactive mask is not in this frame: switch on the anti-aliasing TAA.':
    'En este fotograma no hay máscara reactiva: hay que activar el antialiasing TAA.',
  'The reactive mask is empty: it holds particles, and none is in view.':
    'La máscara reactiva está vacía: contiene partículas, y no hay ninguna a la vista.',
  'The light buffer is not in this frame: choose the technique Light pre-pass or Inferred lighting.':
    'En este fotograma no hay búfer de luz: hay que elegir la técnica Light pre-pass o Iluminación inferida.',
  'No shadow map is in this frame: let a light that is in view cast shadows.':
    'En este fotograma no hay mapas de sombra: hay que hacer que proyecte sombras una luz que esté a la vista.',
  'No profile or image of a light lies in the atlas: give a light that is in view a photometric profile.':
    'En el atlas no hay perfiles ni imágenes de luces: hay que dar un perfil fotométrico a una luz que esté a la vista.',
  'Volumetric fog is not in this frame: switch it on, and look with a camera that has perspective.':
    'En este fotograma no hay niebla volumétrica: se activa, y se mira con una cámara en perspectiva.',
  '{count} objects': '{count} objetos',
  object: 'objeto',
  '{verb} {count} objects': '{verb} {count} objetos',
  '{verb} {name}': '{verb} {name}',
  Deleted: 'Eliminar',
  'Scale##verb': 'Escalar',
  'Set {field} of {name}': 'Cambiar {field} de {name}',
  'Switched on {field} of {name}': 'Activar {field} de {name}',
  'Switched off {field} of {name}': 'Desactivar {field} de {name}',
  'Set {field} of {name} to {value}': 'Cambiar {field} de {name} a {value}',
  'There is one “)” too many.': 'Sobra un «)».',
  'Between “{before}” and “{after}” a sign such as + is missing.':
    'Entre «{before}» y «{after}» falta un signo, por ejemplo +.',
  'What is added has to be in units of one kind.': 'Lo que se suma tiene que estar en unidades de la misma clase.',
  'A number cannot be divided by 0.': 'No se puede dividir entre 0.',
  'A power is of numbers without units.': 'Una potencia es de números sin unidad.',
  'A number is missing.': 'Falta un número.',
  'Something is missing after “{text}”.': 'Falta algo después de «{text}».',
  'A number cannot begin with “{text}”.': 'Un número no puede empezar por «{text}».',
  'Between “{before}” and “{after}” a number is missing.': 'Entre «{before}» y «{after}» falta un número.',
  'After “{text}” a bracket is missing: {text}(…).': 'Después de «{text}» falta un paréntesis: {text}(…).',
  '“{text}” is of a number without a unit.': '«{text}» es de un número sin unidad.',
  'A “)” is missing.': 'Falta un «)».',
  'Before “{text}” a “)” is missing.': 'Antes de «{text}» falta un «)».',
  'Before “{text}” a sign such as + is missing.': 'Antes de «{text}» falta un signo, por ejemplo +.',
  'Before “{text}” a number is missing.': 'Antes de «{text}» falta un número.',
  '“{text}” is neither a unit nor a function.': '«{text}» no es ni una unidad ni una función.',
  'There are too many brackets.': 'Hay demasiados paréntesis.',
  'From {min} to {max}{unit}.': 'De {min} a {max}{unit}.',
  'At least {min}{unit}.': 'Al menos {min}{unit}.',
  'At most {max}{unit}.': 'Como mucho {max}{unit}.',
  'In {unit}.': 'En {unit}.',
  '“{text}” has no place in a number.': '«{text}» no cabe en un número.',
  '“{text}” has two decimal points.': '«{text}» tiene dos separadores decimales.',
  '“{text}” may be {large} or {small}: write one of them.':
    '«{text}» puede ser {large} o {small}: hay que escribir uno de los dos.',
  'This number has no unit: leave the unit out.': 'Este número no tiene unidad: hay que quitarla.',
  'The unit does not fit: this number is in {unit}.': 'La unidad no encaja: este número va en {unit}.',
  'This is too long for a number.': 'Es demasiado largo para un número.',
  'A factor has no unit: leave the unit out.': 'Un factor no tiene unidad: hay que quitarla.',
  'To change a number by a part of it, write *= and a factor, such as *=1.1.':
    'Para cambiar un número en una parte, se escribe *= y un factor, por ejemplo *=1.1.',
  'There is no such number.': 'No existe tal número.',
  'This is larger than a number can be.': 'Es mayor de lo que puede ser un número.',
  'It must be at most {max}{unit}.': 'Debe ser como mucho {max}{unit}.',
  'It must be at least {min}{unit}.': 'Debe ser al menos {min}{unit}.',
  'It must be from {min} to {max}{unit}.': 'Debe estar entre {min} y {max}{unit}.',
  none: 'ninguno',
  'Rotated {name} by {angle}°': 'Rotar {name} {angle}°',
  'Moved {name} by {x}, {y}, {z} m': 'Mover {name} {x}, {y}, {z} m',
  'Scaled {name} by {factor}': 'Escalar {name} por {factor}',
  'Scaled {name} by {x}, {y}, {z}': 'Escalar {name} por {x}, {y}, {z}',
};
