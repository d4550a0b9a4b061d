"""The painting on the walls: mountains and water in ink, with a little blue, ochre and vermilion. It begins on the left
wall, 110 units before the corner, and goes on along the back wall."""
import brush
import noise
from drawing import Plane, bytes_of, pigmented, srgb

WIDE, HIGH = 320.0, 81.6  # of the walls that it covers
PAPER = (0.85, 0.80, 0.69)
INK = (1.75, 1.68, 1.5)
INDIGO = (1.15, 0.66, 0.36)
OCHRE = (0.12, 0.36, 0.8)
VERMILION = (0.12, 1.7, 2.1)


def make(scale):
    plane = Plane(WIDE, HIGH, round(3072 * scale), round(784 * scale))
    painting = brush.Painting(plane)
    dice = brush.dice(2018)

    brush.sun(painting, 178, 57.5, 3.6)
    brush.mountains(painting, 100, [(70, 60, 22), (104, 64, 16), (122, 58, 12), (160, 55, 13), (186, 50, 16), (212, 60, 15),
                                    (250, 56, 20), (290, 60, 18)], base=25, rough=7, tone=0.24, blue=0.22, mist=36, strokes=0.4)
    brush.mountains(painting, 200, [(58, 52, 12), (86, 62, 9), (98, 50, 9), (116, 50, 8), (146, 57, 9), (196, 50, 11),
                                    (226, 54, 12), (270, 50, 14)], base=18, rough=7, tone=0.5, blue=0.25, mist=30, strokes=0.7)
    crest = brush.mountains(painting, 300, [(76, 47, 8), (90, 44, 7), (133, 67, 7), (142, 52, 6), (125, 49, 6), (208, 47, 9),
                                            (222, 58, 9), (262, 44, 12)], base=8, rough=8, tone=0.8, blue=0.22, warm=0.3, mist=25)
    brush.grove(painting, dice, crest, 120, 148, 40, 2.6, 25)
    brush.grove(painting, dice, crest, 70, 95, 30, 2.6, 25)
    brush.birds(painting, dice, 155, 55, 6)
    brush.water(painting, dice, 0, 320, 2, 17, 330)
    crest = brush.mountains(painting, 400, [(66, 30, 12), (96, 24, 9), (112, 25, 10), (150, 24, 11), (163, 20, 8), (228, 30, 12),
                                            (280, 26, 14)], base=2, rough=6, tone=1.0, blue=0.15, warm=0.45, mist=11)
    brush.grove(painting, dice, crest, 56, 175, 110, 3.6, 11)
    brush.grove(painting, dice, crest, 214, 290, 60, 3.6, 11)
    brush.boat(painting, 198, 12, 3.4)
    # pines that lean into the picture from both sides
    brush.branch(painting, dice, (52, 34), 0.45, 26, 1.3, 2)
    brush.branch(painting, dice, (224, 44), 2.85, 28, 1.3, 2)
    brush.seal(painting, dice, 212, 24, 3.6)
    brush.seal(painting, dice, 60, 50, 3.2)

    fibres = noise.fbm(21, plane.shape, 130, 300, 3)
    age = noise.fbm(22, plane.shape, 5, 18, 4)
    grain = 0.8 + 0.4 * fibres  # ink takes to paper unevenly
    sheet = 0.10 * (age - 0.35) + 0.06 * (fibres - 0.5)
    layers = [(painting.ink * grain, INK), (painting.indigo * grain, INDIGO), (painting.ochre, OCHRE),
              (painting.vermilion * (0.7 + 0.6 * fibres), VERMILION), (sheet, (0.7, 1.0, 1.5))]
    return {"landscape.png": bytes_of(srgb(pigmented(PAPER, layers)))}
