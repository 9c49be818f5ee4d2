// The pictures, decoded when they are first shown.

const loading = new Map();  // index in report.images -> Promise of Picture

/// Null where the browser denies access: for linked pictures of a page opened from a file.
function pixelsOf(image) {
  const canvas = make("canvas", { width: image.naturalWidth, height: image.naturalHeight });
  const context = canvas.getContext("2d", { willReadFrequently: true });
  context.drawImage(image, 0, 0);
  try {
    return context.getImageData(0, 0, canvas.width, canvas.height);
  } catch {
    return null;
  }
}

/// {image, width, height, pixels}, or null if the picture is missing or cannot be read.
function loadImage(place) {
  if (place < 0) return Promise.resolve(null);
  if (!loading.has(place)) {
    loading.set(place, new Promise((resolve) => {
      const image = new Image();
      image.onerror = () => resolve(null);
      image.onload = () => resolve({
        image, width: image.naturalWidth, height: image.naturalHeight, pixels: pixelsOf(image),
      });
      image.src = report.images[place].src;
    }));
  }
  return loading.get(place);
}

const blank = (width, height) => make("canvas", { width, height });

/// A canvas of their common size, drawn by paint(out, a, b, width, height) from bytes of RGBA.
function painted(a, b, paint) {
  const canvas = blank(a.width, a.height), context = canvas.getContext("2d");
  const out = context.createImageData(a.width, a.height);
  paint(out.data, a.pixels.data, b.pixels.data, a.width, a.height);
  context.putImageData(out, 0, 0);
  return canvas;
}
