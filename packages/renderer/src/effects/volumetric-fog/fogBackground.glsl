// Fog over the background, mixed in the target's encoding, as three's own fog is.
// three.js r187 tonemapping_fragment, colorspace_fragment
#include "media"
//# main
vec4 media = farol_mediaAt(1e9);
float covers = 1.0 - media.a;
gl_FragColor = vec4(media.rgb / max(covers, 1e-5), 1.0);
#include <tonemapping_fragment>
#include <colorspace_fragment>
gl_FragColor = vec4(gl_FragColor.rgb * covers, covers);
